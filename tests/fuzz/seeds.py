"""Writes what a fuzz target begins with: small files that use what it reads, and a list of words.

    seeds.py NAME FOLDER    makes FOLDER/corpus/NAME/, FOLDER/NAME.dict and FOLDER/tmp/
"""

import pathlib
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]


def words_of(path, pattern=r'"([a-z][a-z0-9_-]*)"'):
    """The quoted names in a source file: what its parser looks for."""
    return sorted(set(re.findall(pattern, (ROOT / path).read_text())))


def cut(text, size=1500):
    """Whole lines from the front of a text."""
    return "".join(line for line in text[:size].splitlines(keepends=True))


# ---- a function for each target: seeds (bytes), words

def obj():
    statements = [
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.2 0\n", "vt 0 0\nvt 1 0\nvt 1 1\n",
        "vn 0 0 1\nvn 0 1 0\n", "f 1 2 3\n", "f 1 2 3 4\n", "f 1 2 5 3 4\n", "f 1/1 2/2 3/3\n",
        "f 1//1 2//2 3//1\n", "f -1/-1/-1 -2/-2/-2 -3/-3/-1\n", "s 1\nf 1 2 3\ns off\n",
        "usemtl a\nf 1 2 3\n", "o thing\ng group\n", "f 1 \\\n2 3\n", "mtllib m.mtl\n",
        "v 1e99 -1e-99 +.5 1\n", "p 1\nl 1 2\n"]
    seeds = ["".join(statements[:n]) for n in range(1, len(statements) + 1)]
    seeds.append(cut((ROOT / "models/scenes/tiled-floor.obj").read_text()))
    return seeds, ["v ", "vt ", "vn ", "f ", "s off", "usemtl ", "mtllib ", "/", "//", "-1", "nan",
                   "inf", "1e308", "1e100", "4294967296", "2147483648", "\\\n", "#", "\r\n"]


def mtl():
    statements = ["newmtl a\nKd 1 0.5 0\nKs 1 1 1\nNs 40\n", "newmtl b\nKa 0.1 0.1 0.1\nillum 1\n",
                  "newmtl c\nmap_Kd t.png\nd 0.5\nTr 0.2\n", "Ke 0 1 0\n", "map_Bump x.png\n",
                  "map_Kd -s 1 1 1 -clamp on t.png\n", "Kd spectral f.rfl\n", "illum 0\n"]
    seeds = ["".join(statements[:n]) for n in range(1, len(statements) + 1)]
    return seeds, ["newmtl ", "Ka ", "Kd ", "Ks ", "Ke ", "Ns ", "Tr ", "d ", "illum ", "map_Kd ",
                   "map_Kd ../", "t.png", "-s ", "-type ", "-clamp on", "spectral", "1e308", "nan"]


def scene():
    seeds = [cut(path.read_text(), 4000) for path in sorted(ROOT.glob("models/scenes/*.toml"))]
    parts = ['[[object]]\nmesh = "a.obj"\n', '[[object]]\nshape = "cube"\nscale = 2\n',
             '[[material]]\nname = "m"\nbrdf = "phong"\nks = 0.5\nmap_kd = "t.png"\n',
             '[[object]]\nmesh = "a.obj"\nmaterial = "m"\nrotate = [1, 2, 3]\n',
             '[[light]]\ntype = "spot"\nposition = [0, 1, 2]\ncutoff = 30\npenumbra = 5\n',
             '[camera]\nposition = [0, 0, 4]\nnear = 0.1\nfar = 9\nprojection = "orthographic"\n',
             '[render]\nshading = "flat"\nset = ["shininess=3"]\nlight = ["point:1,2,3"]\n',
             '[image]\nsize = [8, 8]\nbackground = [0, 0, 0]\nsamples = 4\n']
    seeds += ["".join(parts[:n]) for n in range(1, len(parts) + 1)] + parts
    words = []
    for path in ("src/scene/scene_file.cpp", "src/scene/scene_parts.cpp", "src/scene/options.cpp",
                 "src/scene/shapes.cpp", "src/scene/light.cpp"):
        words += words_of(path)
    return seeds, sorted(set(words)) + ["[[object]]", "[[light]]", "[[material]]", "[camera]",
                                        "[render]", "1e308", "inf", "nan", "../a.obj"]


def png(width, height, depth, colour, row, interlaced=0):
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))
    header = struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, interlaced)
    palette = chunk(b"PLTE", bytes(range(48))) if colour == 3 else b""
    rows = b"".join(bytes([y % 5]) + row for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + palette +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def image():
    seeds = [png(4, 6, 8, 2, bytes(range(12))), png(4, 5, 8, 0, b"\1\2\3\4"),
             png(4, 5, 16, 6, bytes(range(32))), png(8, 5, 1, 0, b"\xa5"),
             png(4, 5, 4, 3, b"\x12\x34"), png(3, 5, 8, 4, bytes(6)),
             png(1, 1, 8, 2, b"\1\2\3", interlaced=1)]
    row = bytes(range(12))
    seeds.append(b"BM" + struct.pack("<IHHIIiiHHIIiiII", 54 + 24, 0, 0, 54, 40, 4, 2, 1, 24, 0, 24,
                                     0, 0, 0, 0) + row * 2)
    seeds.append(struct.pack("<BBBHHBHHHHBB", 0, 0, 2, 0, 0, 0, 0, 0, 4, 2, 24, 0) + row * 2)
    seeds.append(struct.pack("<BBBHHBHHHHBB", 0, 0, 10, 0, 0, 0, 0, 0, 4, 2, 24, 0) +
                 b"\x83abc\x03" + row)
    if shutil.which("convert"):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder) / "a.png"
            source.write_bytes(png(16, 16, 8, 2, bytes(range(48))))
            for name, options in (("a.jpg", []), ("b.jpg", ["-interlace", "JPEG"]),
                                  ("c.jpg", ["-colorspace", "Gray"]),
                                  ("d.jpg", ["-sampling-factor", "2x2"]), ("e.bmp", []),
                                  ("f.tga", ["-compress", "RLE"])):
                out = pathlib.Path(folder) / name
                subprocess.run(["convert", source, *options, out], check=True)
                seeds.append(out.read_bytes())
    return seeds, ["IHDR", "IDAT", "PLTE", "tRNS", "IEND", "CgBI", "JFIF", "Exif", "Adobe", "BM"]


def options():
    names = re.findall(r'^    \{"([a-z-]+)", "([^"]*)"', (ROOT / "src/scene/options.cpp").read_text(),
                       re.M)
    values = {"W,H": "64,48", "NAME=V[,V,V]|NAME=WORD": "kd=1,0,0.5", "TYPE:...": "point:1,2,3:1,1,1",
              "X,Y,Z": "1,2,3", "R,G,B": "0,0.5,1", "N": "4", "DEG": "45", "EV": "-1.5",
              "LEVELS": "2", "NAME|unlit": "phong"}
    lines = [f"--{name}" + (f"\n{values.get(form, form.split('|')[0])}" if form else "")
             for name, form in names]
    lines += ["--repeat\n3", "--max-error=1", "--limit\nflip=0.1", "--verbose", "--help", "--"]
    lines += ["--light\n" + light for light in (
        "spot:1,2,3:0,0,1:30:1,1,1:1,0,0", "cosine:0,0,0:0,1,0", "directional:1,1,1:.1,.2,.3")]
    seeds = ["a.obj\n-o\nb.png\n" + line for line in lines] + ["\n".join(["in"] + lines)]
    words = [f"--{name}" for name, _ in names] + words_of("src/scene/options.cpp")
    return seeds, sorted(set(words)) + [":", ",", "=", "nan", "1e999", "-1", "\n"]


def numbers(length):
    """Tapes of random numbers, two bytes each."""
    made = random.Random(1)
    return [bytes(made.randrange(256) for _ in range(2 * n)) for n in (8, length, length)], []


TARGETS = {"obj": obj, "mtl": mtl, "scene": scene, "image": image, "options": options,
           "walk": lambda: numbers(40), "clip": lambda: numbers(24), "plan": lambda: numbers(400)}


def main():
    name, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    seeds, words = TARGETS[name]()
    corpus = folder / "corpus" / name
    corpus.mkdir(parents=True, exist_ok=True)
    (folder / "tmp").mkdir(exist_ok=True)
    for i, seed in enumerate(seeds):
        (corpus / f"seed-{i}").write_bytes(seed if isinstance(seed, bytes) else seed.encode())
    quoted = ("".join(f"\\x{byte:02x}" for byte in word.encode()) for word in words)
    (folder / f"{name}.dict").write_text("# words\n" + "".join(f'"{word}"\n' for word in quoted))


if __name__ == "__main__":
    main()
