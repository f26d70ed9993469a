//! The results file of CalculiX, as text: the last of each field at the nodes.

use std::path::Path;

/// Fields at the nodes, by node index; empty where the file has none.
#[derive(Debug, Clone, Default)]
pub struct Fields {
    pub displacement: Vec<[f64; 3]>,
    /// xx yy zz xy yz zx.
    pub stress: Vec<[f64; 6]>,
    pub pressure: Vec<f64>,
}

/// Reads the file at `path` of a mesh with `nodes` nodes, numbered from 1.
///
/// # Errors
/// Where the file cannot be read or is none.
pub fn read(path: &Path, nodes: usize) -> Result<Fields, String> {
    let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
    let mut fields = Fields::default();
    let mut block = "";
    for line in text.lines() {
        match line.get(..3) {
            Some(" -4") => {
                block = line.split_whitespace().nth(1).unwrap_or_default();
                match block {
                    "DISP" => fields.displacement = vec![[0.0; 3]; nodes],
                    "STRESS" => fields.stress = vec![[0.0; 6]; nodes],
                    "CONTACT" => fields.pressure = vec![0.0; nodes],
                    _ => {}
                }
            }
            Some(" -3") => block = "",
            Some(" -1") => {
                let wrong = || format!("{}: not understood: {line}", path.display());
                let node = line.get(3..13).and_then(|n| n.trim().parse::<usize>().ok());
                let node = node.ok_or_else(wrong)?.wrapping_sub(1);
                let value = |i: usize| {
                    let text = line.get(13 + 12 * i..25 + 12 * i);
                    text.and_then(|t| t.trim().parse::<f64>().ok())
                        .ok_or_else(wrong)
                };
                if node >= nodes {
                    continue;
                }
                match block {
                    "DISP" => fields.displacement[node] = [value(0)?, value(1)?, value(2)?],
                    "STRESS" => {
                        for i in 0..6 {
                            fields.stress[node][i] = value(i)?;
                        }
                    }
                    "CONTACT" => fields.pressure[node] = value(3)?,
                    _ => {}
                }
            }
            _ => {}
        }
    }
    match fields.displacement.is_empty() || fields.stress.is_empty() {
        true => Err(format!(
            "{} has no displacements or stresses",
            path.display()
        )),
        false => Ok(fields),
    }
}
