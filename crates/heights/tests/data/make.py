"""Makes the height maps beside it by GDAL (`rasterio`) and `tifffile`; tests/files.rs states what they hold.

    python make.py            (with rasterio==1.4.4 tifffile==2026.3.3 numpy)

Cell (row j, column i) of all of them has the height i / 8 - j / 4 m (eight times that in `point.tif`, whose cells are whole numbers), and no data at row 1, column 2.
"""

from pathlib import Path

import numpy as np
import rasterio
import rasterio.shutil
import tifffile
from rasterio.transform import Affine

HERE = Path(__file__).parent
ROWS, COLUMNS = 4, 6
j, i = np.mgrid[:ROWS, :COLUMNS]
HEIGHTS = i / 8 - j / 4
METRES = "EPSG:32633"
NORTH_UP = Affine(0.5, 0, 100, 0, -0.25, 200)


def gdal(name, heights=HEIGHTS, no_data=-9999.0, dtype="float32", transform=NORTH_UP, crs=METRES, tags=None, count=1, driver="GTiff", **options):
    heights = heights.astype(dtype)
    if no_data is not None:
        heights[1, 2] = no_data
    profile = dict(driver=driver, height=ROWS, width=COLUMNS, count=count, dtype=dtype, nodata=no_data, transform=transform, crs=crs)
    with rasterio.open(HERE / name, "w", **profile, **options) as file:
        for band in range(count):
            file.write(heights, band + 1)
        if tags:
            file.update_tags(**tags)
        if "scales" in name:
            file.scales, file.offsets = (0.01,), (3.0,)


gdal("plain.tif")
gdal("deflate.tif", compress="deflate", predictor=3, tiled=True, blockxsize=16, blockysize=16)
gdal("turned.tif", dtype="float64", no_data=float("nan"), compress="lzw", transform=Affine(0.4, 0.15, 100, 0.3, -0.2, 200))
gdal("point.tif", heights=8 * HEIGHTS, dtype="int16", no_data=-32768, compress="lzw", predictor=2, tags={"AREA_OR_POINT": "Point"})
gdal("float_code.tif", no_data=-3.4028234663852886e38)
# What is refused.
gdal("degrees.tif", crs="EPSG:4326")
gdal("feet.tif", crs="EPSG:2225")
gdal("two_bands.tif", count=2)
gdal("nowhere.tif", transform=None, crs=None)
gdal("scales.tif")
gdal("no_code.tif", heights=np.where((i == 2) & (j == 1), -3.4e38, HEIGHTS), no_data=None)
gdal("zstd.tif", compress="zstd")
# BigTIFF with the highest byte first.
heights = HEIGHTS.astype("float32")
heights[1, 2] = np.nan
tags = [(33550, "d", 3, (0.5, 0.25, 0.0), True), (33922, "d", 6, (0, 0, 0, 100, 200, 0), True)]
tifffile.imwrite(HERE / "big.tif", heights, bigtiff=True, byteorder=">", photometric="minisblack", extratags=tags, metadata=None, software=False)
# ESRI's grid has square cells.
square = Affine(0.5, 0, 100, 0, -0.5, 200)
with rasterio.open(HERE / "plain.tif") as file:
    values = file.read(1)
gdal_ascii = rasterio.MemoryFile()
with gdal_ascii.open(driver="GTiff", height=ROWS, width=COLUMNS, count=1, dtype="float32", nodata=-9999.0, transform=square, crs=METRES) as file:
    file.write(values, 1)
with gdal_ascii.open() as file:
    rasterio.shutil.copy(file, HERE / "grid.asc", driver="AAIGrid")
for extra in HERE.glob("*.xml"):
    extra.unlink()
(HERE / "grid.prj").unlink(missing_ok=True)
