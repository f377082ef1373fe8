"""What docs/open_fields.py makes of a file of fields, against the file's own numbers."""
import sys

import numpy
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.insert(0, sys.argv[1])
from open_fields import open_run  # noqa: E402

view, stress = open_run(sys.argv[2])
stress.UpdatePipeline(view.ViewTime)
data = servermanager.Fetch(stress)
values = {name: vtk_to_numpy(data.GetPointData().GetArray(name)) for name in stress.PointData.keys()}
tensor, principal = values["Stress"].reshape(-1, 3, 3), values["PrincipalStress"]
largest = abs(principal).max()
assert largest > 1e8, "no stress"
assert (tensor == tensor.transpose(0, 2, 1)).all()
assert (principal[:, 0] >= principal[:, 1]).all() and (principal[:, 1] >= principal[:, 2]).all()
assert abs(tensor[:, 0, 0] - values["StressXX"]).max() == 0 and abs(tensor[:, 0, 2] - values["StressZX"]).max() == 0
# hssolve's stress of von Mises is by components; rounding alone is between the two
a, b, c = principal.T
mises = numpy.sqrt(((a - b) ** 2 + (b - c) ** 2 + (c - a) ** 2) / 2)
assert abs(mises - values["VonMises"]).max() < 1e-9 * largest, abs(mises - values["VonMises"]).max()
# deformed: the body is longer by what the grips were moved
assert numpy.ptp(vtk_to_numpy(data.GetPoints().GetData())[:, 0]) > (1 + 1e-4) * 63 * 25e-6
print(f"{data.GetNumberOfPoints()} particles, radius {view.Representations[0].GaussianRadius:.6g} m, largest stress {largest:.3g} Pa")
