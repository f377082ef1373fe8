"""Opens the fields of hssolve -o in ParaView as they are best looked at.

    pvpython open_fields.py fields.e run.pvsm [picture.png] [VARIABLE]    then: paraview run.pvsm

Particles as spheres of half a spacing on the deformed body, coloured by plastic strain (or VARIABLE) in one range over all
times; the six components of the stress as one tensor, Stress, for glyphs, and its principal values, PrincipalStress
(first the largest).  Needs ParaView 5.11 or later.
"""
import sys

from paraview import servermanager
from paraview.simple import *  # noqa: F403 (as ParaView's own traces have it)

USUAL = ("EquivalentPlasticStrain", "Damage", "VonMises", "Phase", "Displacement")

STRESS = """
import numpy
names = ["StressXX", "StressYY", "StressZZ", "StressXY", "StressYZ", "StressZX"]
points = inputs[0].PointData
if set(names) <= set(points.keys()):
    xx, yy, zz, xy, yz, zx = [numpy.asarray(points[name]) for name in names]
    tensor = numpy.stack([xx, xy, zx, xy, yy, yz, zx, yz, zz], axis=1)
    output.PointData.append(tensor, "Stress")
    output.PointData.append(numpy.linalg.eigvalsh(tensor.reshape(-1, 3, 3))[:, ::-1].copy(), "PrincipalStress")
"""


def spacing(data):
    """Distance of the first particle to its nearest neighbour, m."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    return (((points[1:] - points[0]) ** 2).sum(axis=1).min()) ** 0.5


def open_run(fields, variable=None):
    """The pipeline of a file of fields, shown in a view; returns view and last filter."""
    reader = ExodusIIReader(FileName=[fields])
    reader.PointVariables = reader.PointVariables.GetAvailable()
    reader.ApplyDisplacements = 0
    merged = MergeBlocks(Input=reader)
    merged.UpdatePipeline(reader.TimestepValues[0])
    radius = spacing(servermanager.Fetch(merged)) / 2
    reader.ApplyDisplacements = 1
    stress = ProgrammableFilter(Input=merged, Script=STRESS, CopyArrays=1)
    RenameSource("Stress as a tensor", stress)
    stress.UpdatePipeline(reader.TimestepValues[-1])

    view = CreateView("RenderView")
    view.ViewTime = reader.TimestepValues[-1]
    AssignViewToLayout(view=view)
    display = Show(stress, view)
    display.Representation = "Point Gaussian"
    display.GaussianRadius = radius
    display.ShaderPreset = "Sphere"
    known = stress.PointData.keys()
    variable = variable or next((name for name in USUAL if name in known), None)
    if variable not in known:
        sys.exit(f"{fields}: no {variable}; there are {', '.join(known)}")
    ColorBy(display, ("POINTS", variable))
    colours = GetColorTransferFunction(variable)
    colours.ApplyPreset("Viridis (matplotlib)", True)
    display.RescaleTransferFunctionToDataRangeOverTime()
    display.SetScalarBarVisibility(view, True)
    black = [0, 0, 0]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    bar = GetScalarBar(colours, view)
    bar.TitleColor = bar.LabelColor = black
    bar.TitleFontSize = bar.LabelFontSize = 12
    time = Show(AnnotateTimeFilter(Input=stress, Format="t = {time:g} s"), view)
    time.Color = black
    time.FontSize = 12
    animation = GetAnimationScene()
    animation.UpdateAnimationUsingDataTimeSteps()
    animation.GoToLast()
    Render(view)
    view.ResetCamera(True)
    return view, stress


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    picture = next((name for name in sys.argv[3:] if name.endswith(".png")), None)
    asked = next((name for name in sys.argv[3:] if not name.endswith(".png")), None)
    shown, _ = open_run(sys.argv[1], asked)
    SaveState(sys.argv[2])
    if picture:
        SaveScreenshot(picture, shown, ImageResolution=[1200, 600])
