"""What a file that is not read hears: what it looks like, what is read, and the nearest way."""

import io
import zipfile

import pytest

from dmp_teach.errors import RecordingError
from dmp_teach.formats.read import read_recording
from dmp_teach.formats.registry import known_formats


def packed(*names):
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        for name in names:
            archive.writestr(name, "x")
    return file.getvalue()


STRANGERS = {
    b"\x89PNG\r\n\x1a\n\0\0": "a picture .PNG.*save that as SVG",
    b"\xff\xd8\xff\xe0\0\x10JFIF": "a picture .JPEG.",
    b"II*\0\x08\0\0\0": "a picture .TIFF.",
    b"RIFF\x10\0\0\0WEBPVP8 ": "a picture .WebP.",
    b"\0\0\0\x18ftypheic\0\0": "a picture .HEIC",
    b"%PDF-1.7\n": "a PDF document.*Inkscape",
    b"%!PS-Adobe-3.0 EPSF": "a PostScript drawing",
    b"{\\rtf1\\ansi": "a rich-text document",
    b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0": "an old Office file",
    b"\x1f\x8b\x08\0": "an archive .gzip.*unpack it",
    b"7z\xbc\xaf\x27\x1c": "an archive .7z.",
    b"Rar!\x1a\x07": "an archive .RAR.",
    bytes(257) + b"ustar\x0000": "an archive .tar.",
    packed("word/document.xml"): "a Word document",
    packed("xl/workbook.xml"): "an Excel workbook.*save the sheet as CSV with the columns t, x, y",
    packed("ppt/presentation.xml"): "a PowerPoint presentation",
    packed("mimetype", "content.xml"): "a document of LibreOffice",
    packed("a/b.txt"): "an archive .ZIP.",
    b"PK\x03\x04 broken": "an archive .ZIP.",
    b"\0\x01\0\0\0\x0f\0\x80": "a font.*single-line",
    b"wOF2\0\x01\0\0": "a font",
    b"\0\0\0\x20ftypisom\0\0\x02\0": "a film",
    b"ID3\x04\0\0": "a sound",
    b"#ROSBAG V2.0\n": "a ROS 1 bag.*columns t, x, y, z",
    b"\x89MCAP0\r\n": "a ROS 2 bag",
    b"SQLite format 3\0": "a database .SQLite, as ROS 2 bags are.",
    b"\x02P\x1b\0\0\0\x01\0\x9a\x03\0\0\x80?": "motion capture .C3D.*export the pen's marker",
    b"HIERARCHY\nROOT Hips\n{": "motion capture .BVH.",
    b"PathFileType\t4\t(X/Y/Z)\ta.trc\n": "motion capture .TRC.",
    b"NO_OF_FRAMES\t100\n": "motion capture .Qualisys.",
    b"Trajectories\r\n100\r\n,,pen:tip\r\n": "motion capture .Vicon.",
    b"solid letter\nfacet normal 0 0 1": "a 3-D model",
    b"  0\nSECTION\n  2\nHEADER": "a CAD drawing .DXF.",
    b"IN;SP1;PU100,200;PD300,400;": "a plotter's file .HPGL.",
    b"; by a slicer\nG21 ; mm\nG90\nG0 X1 Y2\n": "a machine's program .G-code.",
    b"%\nO1000\n".replace(b"O1000", b"N10 G21") + b"G1 X1\n": "a machine's program .G-code.",
    b"2\n100 200 5 1 30 60 512\n101 201 6 1 30 60 513\n": "a tablet's log .SVC2004 or PaHaW.",
    b"// UJI pen characters\nWORD a trn_UJI_W01-01\n  NUMSTROKES 1\n": "the UJI pen characters",
    b'{"cells": [], "nbformat": 4}': "a notebook .Jupyter.",
    b"<!DOCTYPE html><html></html>": "a web page",
    b'{"type": "FeatureCollection"}': "a map .GeoJSON.",
    b'{"strokes": [[[0, 0], [1, 1]]]}': "JSON of another program.*CSV with the columns t, x, y",
    b"[[0.0, 0.1], [0.1, 0.2]]": "JSON of another program",
    b'<?xml version="1.0"?><WhiteboardCaptureSession/>': "IAM-OnDB ink",
    b'<?xml version="1.0"?><robot name="fetch"/>': "a robot's model .URDF.",
    b"<note>x</note>": "an XML file of another kind",
    b"\x80\x04\x95\x10\0": "pickled Python objects",
    b"\x89HDF\r\n\x1a\n": "data .HDF5.",
    b"# a script\nimport numpy as np\n": "a program .Python.",
    b"PAR1\x15\x04": "a table .Parquet",
    b"Dear Anna, thank you for your letter.": "text without a row of numbers.*columns t, x, y",
    bytes(range(128, 256)): "nothing that is known here",
}


@pytest.mark.parametrize("data", STRANGERS, ids=list(map(str, range(len(STRANGERS)))))
def test_a_stranger_is_told_what_it_is_and_the_nearest_way(tmp_path, data):
    """In one sentence, whatever its name says."""
    path = tmp_path / "a_w01.csv"
    path.write_bytes(data)
    with pytest.raises(RecordingError, match=rf"a_w01.csv looks like {STRANGERS[data]}") as caught:
        read_recording(path)
    sentence = str(caught.value)
    assert [each.name for each in known_formats() if str(each) not in sentence] == []
    assert sentence.endswith(".")
    assert len(sentence) < 500
