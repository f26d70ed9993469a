//! Unstructured grids as `.vtu` files.
//!
//! Written here rather than by the crate `vtkio`, whose 0.7.0-rc2 cannot name components, takes
//! arrays by value, and returns success from a disk that is full.

use std::borrow::Cow;
use std::io::{self, Write};
use std::path::Path;

use super::encode::Values;
use super::text::escape;
use crate::ground::file::{FileError, write_atomically};

/// VTK's cell types that Brinell writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CellType {
    Quad = 9,
    Hexahedron = 12,
}

/// A named array of points or cells.
#[derive(Debug, Clone)]
pub struct Array<'a> {
    pub name: &'a str,
    /// Names of the components; one empty name for a scalar.
    pub components: &'a [&'a str],
    pub values: Values<'a>,
}

/// A grid of cells of one type.
#[derive(Debug, Clone)]
pub struct Grid<'a> {
    /// Coordinates x y z of each point.
    pub points: Cow<'a, [f64]>,
    pub cell_type: CellType,
    /// Points of each cell, one cell after the other.
    pub connectivity: Vec<i64>,
    pub point_data: Vec<Array<'a>>,
    pub cell_data: Vec<Array<'a>>,
    /// Lists of names that explain indices, such as those of the bodies.
    pub names: Vec<(&'a str, Vec<String>)>,
}

impl CellType {
    fn corners(self) -> usize {
        match self {
            Self::Quad => 4,
            Self::Hexahedron => 8,
        }
    }
}

impl<'a> Array<'a> {
    /// A scalar array.
    pub fn scalar(name: &'a str, values: Values<'a>) -> Self {
        Self {
            name,
            components: &[""],
            values,
        }
    }

    /// An array of three components X, Y, Z.
    pub fn vector(name: &'a str, values: impl Into<Cow<'a, [f64]>>) -> Self {
        Self {
            name,
            components: &["X", "Y", "Z"],
            values: Values::F64(values.into()),
        }
    }

    /// An array of symmetric tensors in the order xx yy zz xy yz zx, which is also VTK's.
    pub fn tensor(name: &'a str, values: impl Into<Cow<'a, [f64]>>) -> Self {
        let components = &["XX", "YY", "ZZ", "XY", "YZ", "ZX"];
        Self {
            name,
            components,
            values: Values::F64(values.into()),
        }
    }

    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let (kind, name) = (self.values.type_name(), escape(self.name));
        write!(out, "<DataArray type=\"{kind}\" Name=\"{name}\"")?;
        write!(out, " NumberOfComponents=\"{}\"", self.components.len())?;
        for (i, name) in self
            .components
            .iter()
            .enumerate()
            .filter(|(_, name)| !name.is_empty())
        {
            write!(out, " ComponentName{i}=\"{}\"", escape(name))?;
        }
        writeln!(out, " format=\"binary\">")?;
        self.values.write(out)?;
        writeln!(out, "\n</DataArray>")
    }
}

impl Grid<'_> {
    /// Writes the grid to `path`, atomically.
    ///
    /// # Errors
    /// [`FileError::Write`] names the path.
    pub fn write(&self, path: &Path) -> Result<(), FileError> {
        write_atomically(path, |out| self.write_xml(out))
    }

    fn write_xml(&self, out: &mut dyn Write) -> io::Result<()> {
        let corners = self.cell_type.corners();
        let cells = self.connectivity.len() / corners;
        writeln!(out, "<?xml version=\"1.0\"?>")?;
        write!(out, "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\"")?;
        write!(out, " byte_order=\"LittleEndian\" header_type=\"UInt64\"")?;
        writeln!(
            out,
            " compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>"
        )?;
        writeln!(out, "<FieldData>")?;
        for (name, list) in &self.names {
            write_names(out, name, list)?;
        }
        writeln!(out, "</FieldData>")?;
        let points = self.points.len() / 3;
        writeln!(
            out,
            "<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">"
        )?;
        write_section(out, "PointData", &self.point_data)?;
        write_section(out, "CellData", &self.cell_data)?;
        let points = Array::vector("Points", self.points.as_ref());
        write_section(out, "Points", &[points])?;
        let offsets: Vec<i64> = (1..=cells).map(|i| (i * corners) as i64).collect();
        let types = vec![self.cell_type as u8; cells];
        let topology = [
            Array::scalar(
                "connectivity",
                Values::I64(self.connectivity.as_slice().into()),
            ),
            Array::scalar("offsets", Values::I64(offsets.into())),
            Array::scalar("types", Values::U8(types.into())),
        ];
        write_section(out, "Cells", &topology)?;
        writeln!(out, "</Piece>\n</UnstructuredGrid>\n</VTKFile>")
    }
}

fn write_section(out: &mut dyn Write, name: &str, arrays: &[Array]) -> io::Result<()> {
    writeln!(out, "<{name}>")?;
    for array in arrays {
        array.write(out)?;
    }
    writeln!(out, "</{name}>")
}

/// VTK keeps strings as character codes, each string ended by a zero.
fn write_names(out: &mut dyn Write, name: &str, list: &[String]) -> io::Result<()> {
    write!(out, "<DataArray type=\"String\" Name=\"{}\"", escape(name))?;
    writeln!(out, " NumberOfTuples=\"{}\" format=\"ascii\">", list.len())?;
    for entry in list {
        for byte in entry.bytes() {
            write!(out, "{byte} ")?;
        }
        writeln!(out, "0")?;
    }
    writeln!(out, "</DataArray>")
}
