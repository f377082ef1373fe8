#include "foreign.h"

#include "die.h"

#include <string.h>
#include <strings.h>

#define SAVE "save the sheet or the measured values as CSV or text"
#define MESH "a body, not a curve; hspost reads what hssolve or a testing machine has recorded"

static const struct {
    const char *begins, *what, *advice;
} formats[] = {
    {"PK\3\4", "an Excel workbook (xlsx) or another zip archive", SAVE},
    {"\xD0\xCF\x11\xE0", "an old Excel workbook (xls) or another Office file", SAVE},
    {"%PDF", "a PDF", "the numbers are needed; digitise the figure or ask for the table"},
    {"\x89PNG", "a picture (PNG)", "digitise the curve first"},
    {"\xFF\xD8\xFF", "a picture (JPEG)", "digitise the curve first"},
    {"GIF8", "a picture (GIF)", "digitise the curve first"},
    {"\x1F\x8B", "compressed by gzip (zs2 of testXpert, too)", "unpack or export it as text"},
    {"MATLAB 5.0", "a MATLAB file", "write the columns by writetable"},
    {"TDSm", "a TDMS file of LabVIEW", "export it as text"},
    {"SQLite format 3", "a database (SQLite)", "export the measured values as CSV"},
    {"{", "JSON", "a table of columns is needed"},
    {"$MeshFormat", "a mesh of Gmsh", MESH},
    {"*Heading", "an input of Abaqus or CalculiX", MESH},
    {"*Node", "an input of Abaqus or CalculiX", MESH},
    {"***tesr", "a voxel tessellation of Neper", MESH},
    {"***tess", "a tessellation of Neper", MESH},
    {"# vtk DataFile", "a VTK file", MESH},
    {"<?xml", "XML (a VTK file, perhaps)", "a table of columns is needed"},
    {"<html", "a page of the web (HTML)", SAVE},
    {"<!DOCTYPE html", "a page of the web (HTML)", SAVE},
    {"<VTKFile", "a VTK file", MESH},
    {"solid ", "a surface in STL", MESH},
    {"%YAML", "YAML, a deck perhaps", "a deck goes through hsgen first"},
};

void foreign_refuse(const char *bytes, long length, const char *name)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        const size_t n = strlen(formats[i].begins);
        if ((size_t)length >= n && strncasecmp(bytes, formats[i].begins, n) == 0)
            die_user("%s is %s: %s", name, formats[i].what, formats[i].advice);
    }
}
