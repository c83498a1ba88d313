"""What a file that is not read looks like, and the nearest way from it to ink."""

from __future__ import annotations

import io
import re
import zipfile
from dataclasses import dataclass

BEGIN_OF_STRANGER = 4096  # bytes of a file in which its kind shows

DRAW = "redraw the letter over it as open lines, such as in Inkscape, and save that as SVG"
FROM_PROGRAM = "save the drawing as SVG in the program that made it"
SHEET = "save the sheet as CSV with the columns t, x, y"
UNPACK = "unpack it and read what is in it"
CAPTURE = "export the pen's marker as CSV with the columns t, x, y, z"
ROBOT = "write the poses as CSV with the columns t, x, y, z"
NOTES = "export the page as InkML or SVG, with its pen strokes"
PENLESS = "record the letter on the pad, or write the pen's places as CSV: t, x, y"
TO_NUMBERS = "write its numbers as CSV with the columns t, x, y"
NAME_COLUMNS = "write the names of its columns for the count above them: y x t pen ... pressure"
FONT = "set the letter in a single-line font, convert it to paths, and save that as SVG"


@dataclass(frozen=True)
class Kind:
    """A kind of file.

    Args:
        name: With its article, for a sentence.
        signs: What such a file begins with.
        cure: What to do with it.
    """

    name: str
    signs: str
    cure: str


# In a regular expression of bytes, over the first 4096 of them.
KINDS = (
    Kind("a picture (PNG)", r"\x89PNG", DRAW),
    Kind("a picture (JPEG)", r"\xff\xd8\xff", DRAW),
    Kind("a picture (GIF)", r"GIF8", DRAW),
    Kind("a picture (TIFF)", r"II\*\x00|MM\x00\*", DRAW),
    Kind("a picture (BMP)", r"BM.{4}\x00{4}", DRAW),
    Kind("a picture (WebP)", r"RIFF.{4}WEBP", DRAW),
    Kind("a picture (HEIC or AVIF)", r".{4}ftyp(?:hei|mif|avi|hevc)", DRAW),
    Kind("a picture (Photoshop)", r"8BPS", DRAW),
    Kind("a picture (icon)", r"\x00\x00[\x01\x02]\x00[^\x00]\x00", DRAW),
    Kind("a picture (PBM, PGM or PPM)", r"P[1-6]\s+(?:#.*\s+)?\d+\s+\d+\s", DRAW),
    Kind("a PDF document", r"\s*%PDF", "open the page in Inkscape and save it as SVG"),
    Kind("a PostScript drawing", r"%!PS|\xc5\xd0\xd3\xc6", FROM_PROGRAM),
    Kind("a rich-text document", r"\{\\rtf", PENLESS),
    Kind("an old Office file (.doc, .xls, .ppt)", r"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", SHEET),
    Kind("a OneNote notebook", r"\xe4\x52\x5c\x7b\x8c\xd8\xa7\x4d", NOTES),
    Kind("Windows ink (ISF)", r"base64:A|(?:AI|AP)[A-Za-z0-9+/]{40}", NOTES),
    Kind("an archive (gzip, as .svgz and .xopp are)", r"\x1f\x8b", UNPACK),
    Kind("an archive (7z)", r"7z\xbc\xaf", UNPACK),
    Kind("an archive (RAR)", r"Rar!", UNPACK),
    Kind("an archive (bzip2)", r"BZh[1-9]1AY", UNPACK),
    Kind("an archive (xz)", r"\xfd7zXZ", UNPACK),
    Kind("an archive (Zstandard)", r"\x28\xb5\x2f\xfd", UNPACK),
    Kind("an archive (tar)", r".{257}ustar", UNPACK),
    Kind("a font", r"\x00\x01\x00\x00\x00[\x01-\x40][\x00-\x10]|OTTO|ttcf|wOF[F2]|true\x00", FONT),
    Kind("a film", r".{4}(?:ftyp|moov|mdat)|RIFF.{4}AVI|\x1a\x45\xdf\xa3|FLV", PENLESS),
    Kind("a sound", r"RIFF.{4}WAVE|ID3|OggS|fLaC|\xff[\xfb\xf3\xf2]", PENLESS),
    Kind("a ROS 1 bag", r"#ROSBAG", ROBOT),
    Kind("a ROS 2 bag (MCAP)", r"\x89MCAP", ROBOT),
    Kind("a database (SQLite, as ROS 2 bags are)", r"SQLite format 3", ROBOT),
    Kind("motion capture (C3D)", r"[\x02-\x14]\x50.{9}.", CAPTURE),
    Kind("motion capture (BVH)", r"\s*HIERARCHY\s", CAPTURE),
    Kind("motion capture (TRC)", r"PathFileType\s", CAPTURE),
    Kind("motion capture (Qualisys)", r"NO_OF_FRAMES\s|# ?QTM", CAPTURE),
    Kind("motion capture (Vicon)", r"\W{0,4}(?:Trajectories|Model Outputs|Devices)\W", CAPTURE),
    Kind("a take of Motive without its row Frame,Time", r'"?Format Version', "export it again"),
    Kind("motion capture (AMC)", r"#.{0,200}:FULLY-SPECIFIED|:FULLY-SPECIFIED", CAPTURE),
    Kind("motion capture (FBX)", r"Kaydara FBX|; FBX ", CAPTURE),
    Kind("motion of OpenSim (.mot, .sto)", r".{0,2000}?\bendheader\b", CAPTURE),
    Kind("a 3-D model", r"solid |glTF|ply\s+format|v -?[\d.]+ -?[\d.]+ -?[\d.]+\s", PENLESS),
    Kind("a CAD drawing (DXF)", r"\s*(?:999.{0,200})?0\s+SECTION|AutoCAD|AC10\d\d", FROM_PROGRAM),
    Kind(
        "a plotter's file (HPGL)", r"(?:\x1b\S{1,4}\s*)?(?:IN|PU|SP|PA|DF)\d*[;,\s]", FROM_PROGRAM
    ),
    Kind(
        "a machine's program (G-code)",
        r"(?:[%;(][^\n]*\n|\s)*(?:N\d+ *)?[GMT]\d{1,3}\b",
        FROM_PROGRAM,
    ),
    Kind("a tablet's log (SVC2004 or PaHaW)", r"\s*\d+\s*\n(?:-?\d+ +){6}-?\d+\s*\n", NAME_COLUMNS),
    Kind("the UJI pen characters", r"(?:[^\n]*\n){0,40}?WORD \S+ \S+\s+NUMSTROKES", TO_NUMBERS),
    Kind("a notebook (Jupyter)", r'\s*\{(?=.*"(?:cells|nbformat)"\s*:)', PENLESS),
    Kind("a web page", r"\s*(?i:<!doctype html|<html)", PENLESS),
    Kind("a map (GeoJSON)", r'\s*\{.{0,200}"FeatureCollection"', TO_NUMBERS),
    Kind("JSON of another program", r'\s*(?:\{\s*["}]|\[\s*[\[{"\]\d-])', TO_NUMBERS),
    Kind("IAM-OnDB ink", r".{0,300}<WhiteboardCaptureSession", TO_NUMBERS),
    Kind("notes of Xournal", r".{0,300}<xournal", NOTES),
    Kind("a robot's model (URDF)", r".{0,2000}?<robot\b", PENLESS),
    Kind("an XML file of another kind", r"\s*<\?xml|\s*<[A-Za-z]", PENLESS),
    Kind("pickled Python objects", r"\x80[\x02-\x05]", "save the array with numpy.save"),
    Kind("a table (Parquet or Arrow)", r"PAR1|ARROW1", TO_NUMBERS),
    Kind("data (HDF5)", r"\x89HDF", TO_NUMBERS + ", or by MATLAB with '-v7'"),
    Kind("a program (Python)", r"(?:#[^\n]*\n|\s)*(?:import|from|def|class) \w", PENLESS),
    Kind("a program", r"MZ|\x7fELF|#!|\xca\xfe\xba\xbe|\xcf\xfa\xed\xfe", PENLESS),
)
IN_ZIP = (
    ("word/", "a Word document", PENLESS),
    ("xl/", "an Excel workbook", SHEET),
    ("ppt/", "a PowerPoint presentation", PENLESS),
    ("content.xml", "a document of LibreOffice", "save it as SVG, or a sheet as CSV: t, x, y"),
    ("Index/", "a document of Pages, Numbers or Keynote", SHEET),
    ("Session.plist", "notes of Notability", NOTES),
    ("index.notes", "notes of GoodNotes", NOTES),
    ("META-INF/container.xml", "a book (EPUB)", PENLESS),
    ("", "an archive (ZIP)", UNPACK),
)


def describe_stranger(data: bytes) -> tuple[str, str] | None:
    """Return what a file looks like, and what to do with it; None where nothing tells."""
    if data.startswith(b"PK"):
        names = _names_in_zip(data)
        return next(
            (what, cure) for sign, what, cure in IN_ZIP if any(sign in name for name in names)
        )
    begin = data[:BEGIN_OF_STRANGER].removeprefix(b"\xef\xbb\xbf")
    for kind in KINDS:
        if re.match(kind.signs.encode("latin-1"), begin, re.DOTALL):
            return kind.name, kind.cure
    return None


def describe_text(data: bytes) -> str:
    """Return in a word or two whether a file without a kind can be read by people."""
    begin = data[:BEGIN_OF_STRANGER].decode("utf-8", errors="replace")
    is_text = "\0" not in begin and begin.count("\ufffd") < 0.1 * len(begin)
    return "text without a row of numbers" if is_text else "nothing that is known here"


def _names_in_zip(data: bytes) -> list[str]:
    """Return the names of the files in an archive, at least one."""
    try:
        return [*zipfile.ZipFile(io.BytesIO(data)).namelist(), ""]
    except (zipfile.BadZipFile, ValueError, NotImplementedError, RuntimeError, OSError):
        return [""]
