"""What a file that is not read looks like, and the nearest way from it to ink."""

from __future__ import annotations

import io
import re
import zipfile

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

# What to do with files of a kind, and what they begin with: expressions of bytes, in this order.
KINDS = {
    "a picture (PNG)": (DRAW, r"\x89PNG"),
    "a picture (JPEG)": (DRAW, r"\xff\xd8\xff"),
    "a picture (TIFF)": (DRAW, r"II\*\x00|MM\x00\*"),
    "a picture (WebP)": (DRAW, r"RIFF.{4}WEBP"),
    "a picture (HEIC or AVIF)": (DRAW, r".{4}ftyp(?:hei|mif|avi|hevc)"),
    "a picture (PBM, PGM or PPM)": (DRAW, r"P[1-6]\s+(?:#.*\s+)?\d+\s+\d+\s"),
    "a picture (GIF, BMP, Photoshop or an icon)": (
        DRAW,
        r"GIF8|BM.{4}\x00{4}|8BPS|\x00\x00[\x01\x02]\x00[^\x00]\x00",
    ),
    "a PDF document": ("open the page in Inkscape and save it as SVG", r"\s*%PDF"),
    "a PostScript drawing": (FROM_PROGRAM, r"%!PS|\xc5\xd0\xd3\xc6"),
    "a rich-text document": (PENLESS, r"\{\\rtf"),
    "an old Office file (.doc, .xls, .ppt)": (SHEET, r"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"),
    "a OneNote notebook": (NOTES, r"\xe4\x52\x5c\x7b\x8c\xd8\xa7\x4d"),
    "Windows ink (ISF)": (NOTES, r"base64:A|(?:AI|AP)[A-Za-z0-9+/]{40}"),
    "an archive (gzip, as .svgz and .xopp are)": (UNPACK, r"\x1f\x8b"),
    "an archive (7z)": (UNPACK, r"7z\xbc\xaf"),
    "an archive (RAR)": (UNPACK, r"Rar!"),
    "an archive (tar)": (UNPACK, r".{257}ustar"),
    "an archive (bzip2, xz or Zstandard)": (UNPACK, r"BZh[1-9]1AY|\xfd7zXZ|\x28\xb5\x2f\xfd"),
    "a font": (FONT, r"\x00\x01\x00\x00\x00[\x01-\x40][\x00-\x10]|OTTO|ttcf|wOF[F2]|true\x00"),
    "a film": (PENLESS, r".{4}(?:ftyp|moov|mdat)|RIFF.{4}AVI|\x1a\x45\xdf\xa3|FLV"),
    "a sound": (PENLESS, r"RIFF.{4}WAVE|ID3|OggS|fLaC|\xff[\xfb\xf3\xf2]"),
    "a ROS 1 bag": (ROBOT, r"#ROSBAG"),
    "a ROS 2 bag (MCAP)": (ROBOT, r"\x89MCAP"),
    "a database (SQLite, as ROS 2 bags are)": (ROBOT, r"SQLite format 3"),
    "motion capture (C3D)": (CAPTURE, r"[\x02-\x14]\x50.{9}."),
    "motion capture (BVH)": (CAPTURE, r"\s*HIERARCHY\s"),
    "motion capture (TRC)": (CAPTURE, r"PathFileType\s"),
    "motion capture (Qualisys)": (CAPTURE, r"NO_OF_FRAMES\s|# ?QTM"),
    "motion capture (Vicon)": (CAPTURE, r"\W{0,4}(?:Trajectories|Model Outputs|Devices)\W"),
    "a take of Motive without its row Frame,Time": ("export it again", r'"?Format Version'),
    "motion capture (AMC)": (CAPTURE, r"(?:#.{0,200})?:FULLY-SPECIFIED"),
    "motion capture (FBX)": (CAPTURE, r"Kaydara FBX|; FBX "),
    "motion of OpenSim (.mot, .sto)": (CAPTURE, r".{0,2000}?\bendheader\b"),
    "a 3-D model": (PENLESS, r"solid |glTF|ply\s+format|v -?[\d.]+ -?[\d.]+ -?[\d.]+\s"),
    "a CAD drawing (DXF)": (FROM_PROGRAM, r"\s*(?:999.{0,200})?0\s+SECTION|AutoCAD|AC10\d\d"),
    "a plotter's file (HPGL)": (
        FROM_PROGRAM,
        r"(?:\x1b\S{1,4}\s*)?(?:IN|PU|SP|PA|DF)\d*[;,\s]",
    ),
    "a machine's program (G-code)": (
        FROM_PROGRAM,
        r"(?:[%;(][^\n]*\n|\s)*(?:N\d+ *)?[GMT]\d{1,3}\b",
    ),
    "a tablet's log (SVC2004 or PaHaW)": (NAME_COLUMNS, r"\s*\d+\s*\n(?:-?\d+ +){6}-?\d+\s*\n"),
    "the UJI pen characters": (TO_NUMBERS, r"(?:[^\n]*\n){0,40}?WORD \S+ \S+\s+NUMSTROKES"),
    "a notebook (Jupyter)": (PENLESS, r'\s*\{(?=.*"(?:cells|nbformat)"\s*:)'),
    "a web page": (PENLESS, r"\s*(?i:<!doctype html|<html)"),
    "a map (GeoJSON)": (TO_NUMBERS, r'\s*\{.{0,200}"FeatureCollection"'),
    "JSON of another program": (TO_NUMBERS, r'\s*(?:\{\s*["}]|\[\s*[\[{"\]\d-])'),
    "IAM-OnDB ink": (TO_NUMBERS, r".{0,300}<WhiteboardCaptureSession"),
    "notes of Xournal": (NOTES, r".{0,300}<xournal"),
    "a robot's model (URDF)": (PENLESS, r".{0,2000}?<robot\b"),
    "an XML file of another kind": (PENLESS, r"\s*<\?xml|\s*<[A-Za-z]"),
    "pickled Python objects": ("save the array with numpy.save", r"\x80[\x02-\x05]"),
    "a table (Parquet or Arrow)": (TO_NUMBERS, r"PAR1|ARROW1"),
    "data (HDF5)": (TO_NUMBERS + ", or by MATLAB with '-v7'", r"\x89HDF"),
    "a program (Python)": (PENLESS, r"(?:#[^\n]*\n|\s)*(?:import|from|def|class) \w"),
    "a program": (PENLESS, r"MZ|\x7fELF|#!|\xca\xfe\xba\xbe|\xcf\xfa\xed\xfe"),
}
# Of an archive, by a part of the name of a file in it.
KINDS_OF_ZIP = {
    "word/": ("a Word document", PENLESS),
    "xl/": ("an Excel workbook", SHEET),
    "ppt/": ("a PowerPoint presentation", PENLESS),
    "content.xml": ("a document of LibreOffice", "save it as SVG, or a sheet as CSV: t, x, y"),
    "Index/": ("a document of Pages, Numbers or Keynote", SHEET),
    "Session.plist": ("notes of Notability", NOTES),
    "index.notes": ("notes of GoodNotes", NOTES),
    "META-INF/container.xml": ("a book (EPUB)", PENLESS),
}


def describe_stranger(data: bytes) -> tuple[str, str] | None:
    """Return what a file looks like, and what to do with it; None where nothing tells."""
    if data.startswith(b"PK"):
        try:
            names = zipfile.ZipFile(io.BytesIO(data)).namelist()
        except (zipfile.BadZipFile, ValueError, NotImplementedError, RuntimeError, OSError):
            names = []
        known = (kind for sign, kind in KINDS_OF_ZIP.items() if any(sign in each for each in names))
        return next(known, ("an archive (ZIP)", UNPACK))
    begin = data[:BEGIN_OF_STRANGER].removeprefix(b"\xef\xbb\xbf")
    for kind, (cure, signs) in KINDS.items():
        if re.match(signs.encode("latin-1"), begin, re.DOTALL):
            return kind, cure
    return None


def describe_text(data: bytes) -> str:
    """Return in a word or two whether a file without a kind can be read by people."""
    begin = data[:BEGIN_OF_STRANGER].decode("utf-8", errors="replace")
    is_text = "\0" not in begin and begin.count("\ufffd") < 0.1 * len(begin)
    return "text without a row of numbers" if is_text else "nothing that is known here"
