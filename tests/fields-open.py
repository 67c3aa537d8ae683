#!/usr/bin/env python3
"""fields-open.py -- opens the particle fields of a run with VTK.

    python3 tests/fields-open.py DIR

DIR holds fields.xdmf and fields/.  Every moment that the index names is read by
vtkHDFReader (VTK 9.1 of Debian 12, package python3-vtk9) and, where VTK has an
XDMF reader (ParaView's python3-paraview does, python3-vtk9 does not), the series
is read through the index as well.  One line a moment: reader, time, particles,
cells, smallest and largest pressure, largest speed.

Exit status: 0 all was read, 1 something was not, 77 this Python has no VTK.
"""
import os
import sys
import xml.etree.ElementTree as xml

NAMES = {"velocity", "density", "pressure", "dye", "kind", "id"}


def moments(index):
    """Time and particle file of each moment."""
    for grid in xml.parse(index).getroot().findall("./Domain/Grid/Grid"):
        place = grid.find(".//Geometry/DataItem").text.strip()
        yield float(grid.find("Time").get("Value")), place.split(":")[0]


def show(reader, t, grid):
    """Prints what was read; says whether it is whole."""
    points = grid.GetPointData() if grid is not None else None
    names = {points.GetArrayName(i) for i in range(points.GetNumberOfArrays())} if points else set()
    if not NAMES <= names:
        print(f"{reader} t={t:g}: {', '.join(sorted(NAMES - names))} missing")
        return False
    low, high = points.GetArray("pressure").GetRange()
    speed = points.GetArray("velocity").GetRange(-1)[1]
    print(f"{reader} t={t:g} particles={grid.GetNumberOfPoints()} cells={grid.GetNumberOfCells()}"
          f" pressure={low:g}..{high:g} speed={speed:.4g}")
    return grid.GetNumberOfPoints() == grid.GetNumberOfCells() > 0


def show_bodies(t, path):
    """Prints corners, faces and bodies of a file of surfaces; says whether it is whole."""
    from vtkmodules.vtkIOHDF import vtkHDFReader
    reader = vtkHDFReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    number = grid.GetCellData().GetArray("body")
    bodies = int(number.GetRange()[1]) + 1 if number else 0
    print(f"bodies t={t:g} bodies={bodies} corners={grid.GetNumberOfPoints()}"
          f" faces={grid.GetNumberOfCells()} type={grid.GetCellType(0)}")
    return bodies > 0 and grid.GetPointData().GetArray("velocity") is not None


def by_files(directory, series):
    from vtkmodules.vtkIOHDF import vtkHDFReader
    fine = True
    for t, name in series:
        reader = vtkHDFReader()
        reader.SetFileName(os.path.join(directory, name))
        reader.Update()
        fine = show("hdf", t, reader.GetOutput()) and fine
        bodies = os.path.join(directory, name.replace(".vtkhdf", "-bodies.vtkhdf"))
        if os.path.exists(bodies):
            fine = show_bodies(t, bodies) and fine
    return fine


def by_index(index, series):
    try:
        from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
    except ImportError:
        print("xdmf: this VTK has no XDMF reader")
        return True
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline
    reader = vtkXdmfReader()
    reader.SetFileName(index)
    reader.UpdateInformation()
    times = reader.GetOutputInformation(0).Get(pipeline.TIME_STEPS()) or ()
    fine = list(times) == [t for t, _ in series]
    if not fine:
        print(f"xdmf: times {times} are not those of the index")
    for t in times:
        reader.UpdateTimeStep(t)
        fine = show("xdmf", t, reader.GetOutputDataObject(0)) and fine
    return fine


def main():
    try:
        from vtkmodules.vtkCommonCore import vtkVersion
    except ImportError:
        print("not checked: this Python has no VTK (on Debian: apt-get install python3-vtk9)")
        return 77
    directory = sys.argv[1]
    index = os.path.join(directory, "fields.xdmf")
    series = list(moments(index))
    print(f"VTK {vtkVersion().GetVTKVersion()}, {len(series)} moments")
    fine = by_files(directory, series)
    fine = by_index(index, series) and fine
    return 0 if fine and series else 1


if __name__ == "__main__":
    sys.exit(main())
