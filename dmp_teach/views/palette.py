"""Colours of figures and scenes, after Okabe and Ito: every eye tells them apart."""

TEXT_COLOR = "#1B2430"
MUTED_COLOR = "#5B6470"
GRID_COLOR = "#E6E6E6"
SHADE_COLOR = "#F1EFE6"

PERSON_COLOR = "#D55E00"
ROBOT_COLOR = "#0072B2"
COMPARED_COLOR = "#CC79A7"

# Okabe and Ito's yellow is darkened, to be seen on white.
STROKE_COLORS = (
    "#0072B2",
    "#D55E00",
    "#009E73",
    "#CC79A7",
    "#E69F00",
    "#56B4E9",
    "#000000",
    "#8A7A00",
)
