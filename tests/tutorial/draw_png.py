"""draw_png.py PROGRAM FILE.png: what the tutorial draws, for a screenshot test. It writes PPM."""
import pathlib
import struct
import subprocess
import sys
import zlib

WIDTH, HEIGHT = 256, 144


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


program, png = sys.argv[1], pathlib.Path(sys.argv[2])
ppm = png.with_suffix(".ppm")
subprocess.run([program, ppm, str(WIDTH), str(HEIGHT)], check=True)
data = ppm.read_bytes()
ppm.unlink()
head = f"P6 {WIDTH} {HEIGHT} 255\n".encode()
if not data.startswith(head) or len(data) != len(head) + 3 * WIDTH * HEIGHT:
    sys.exit(f"{ppm}: {data[:20]}, expected {head} and as many pixels")
rows = b"".join(b"\0" + data[len(head) + 3 * WIDTH * y:len(head) + 3 * WIDTH * (y + 1)] for y in range(HEIGHT))
png.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2, 0, 0, 0))
                + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))
