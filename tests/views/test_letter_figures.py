"""Figures of made letters and words show what was made."""

import numpy as np
import pytest

from dmp_teach.errors import LetterError
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.letters.compose.recipes import letters_needed, make_letter, recipes
from dmp_teach.letters.compose.shelf import Shelf
from dmp_teach.letters.text.words import write_word
from dmp_teach.views.figures.letter import draw_made_letters, draw_recipes, draw_text


def test_every_writer_has_a_row_with_the_letter_and_what_each_transformation_makes_of_it():
    figure = draw_made_letters()
    titles = [panel.get_title(loc="left") for panel in figure.axes]
    assert titles[:3] == ["D, writer-1, as shown", "P by DMP*", "P by similarity"]
    assert len(titles) == 6
    shown = figure.axes[1].lines[1].get_xydata()
    made = make_letter("P", Shelf.of([recording_of("D")]), "star").write()[1].position
    np.testing.assert_allclose(shown, 1e3 * made)
    assert figure.axes[0].get_xlim() == figure.axes[2].get_xlim()


def test_strokes_of_a_made_letter_differ_by_line_not_by_colour_alone():
    lines = draw_made_letters().axes[1].lines
    assert len({line.get_linestyle() for line in lines}) == len(lines) == 2


def test_every_recipe_of_a_shelf_is_drawn():
    shelf = Shelf.of(recording_of(letter) for letter in "lo")
    titles = [panel.get_title() for panel in draw_recipes(shelf).axes]
    possible = [each for each in recipes() if set(letters_needed(each[1])) <= set("lo")]
    assert len(possible) >= 4
    assert [title for title in titles if title] == [
        f"{character} of {', '.join(letters_needed(how))}" for character, how in possible
    ]


def test_a_word_is_drawn_in_mm_where_it_stands():
    ink = write_word("no", x_height=0.01)
    panel = draw_text(ink).axes[0]
    np.testing.assert_allclose(panel.lines[0].get_xydata(), 1e3 * ink[0].position)
    whole = draw_text(ink, 0.21, 0.297).axes[0]
    assert whole.get_xlim()[0] < -105
    assert whole.get_ylim()[1] > 148.5


@pytest.mark.parametrize(
    ("ask", "answer"),
    [
        (
            lambda: draw_made_letters("P", "D", [recording_of("a")]),
            r"There is no recording of 'D', so there is nothing to draw",
        ),
        (lambda: draw_made_letters("b", "D"), r"There is no recipe that makes 'b' of 'D' alone"),
        (
            lambda: draw_recipes(Shelf.of([recording_of("e")])),
            r"No recipe can be made of e alone; put more letters",
        ),
    ],
)
def test_nothing_to_draw_is_said(ask, answer):
    with pytest.raises(LetterError, match=answer):
        ask()
