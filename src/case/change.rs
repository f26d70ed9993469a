//! Changes to a case from outside of its file, such as `--mesh` and `--full`.

use super::assumption::Assumption;
use super::bearing::UNLOAD_TO;
use super::bearing::{MeshRequest, Preset, Scales, Strips, UnknownPreset};
use super::error::{CaseError, ErrorKind};
use super::nearest::{advice, list};
use super::{BearingCase, Case, Kind, MeshOrigin};
use crate::model::scene::{Controls, ElementKind, SolverKind};

impl Case {
    /// Meshes the bearing by another preset than the file says. Numbers that the file sets in
    /// place of those of its own preset are dropped, and so is its scale.
    ///
    /// # Errors
    /// Where there is no such preset, it does not fit the bearing, or the case is a general scene, which has a mesh file.
    pub fn set_preset(&mut self, name: &str) -> Result<(), CaseError> {
        let names = || Preset::ALL.iter().map(|preset| preset.name());
        let preset: Preset = name.parse().map_err(|unknown: UnknownPreset| {
            CaseError::new(ErrorKind::Value, unknown.to_string()).help(advice(name, names()))
        })?;
        let bearing = self.bearing_mut("a mesh preset")?;
        let offered = bearing.geometry.presets();
        if !offered.contains(&preset) {
            let table = bearing.geometry.table();
            let names = list(offered.iter().map(|preset| preset.name()));
            let message = format!("the preset `{preset}` does not go with [{table}]");
            return Err(CaseError::new(ErrorKind::Value, message).help(format!("one of: {names}")));
        }
        let dropped = bearing.mesh.own_numbers();
        let request = MeshRequest {
            preset,
            strips: bearing.mesh.strips,
            full: bearing.mesh.full,
            ..MeshRequest::default()
        };
        set_mesh(bearing, request)?;
        self.note("mesh.preset", preset.name());
        if !dropped.is_empty() {
            let keys = list(dropped.iter().map(String::as_str));
            let why = format!(
                "asked for when the case was run: what [mesh] of the file has beside its preset, {keys}, does not count"
            );
            let assumption = Assumption::new("mesh", format!("{preset} alone"), &why, false);
            self.assumptions.push(assumption);
        }
        Ok(())
    }

    /// Models the whole bearing though it is symmetric.
    ///
    /// # Errors
    /// Where the case is a general scene, whose mesh is what it is.
    pub fn set_full(&mut self) -> Result<(), CaseError> {
        let bearing = self.bearing_mut("a full model")?;
        bearing.mesh.full = true;
        let key = format!("{}.full", bearing.geometry.table());
        self.note(&key, "the whole bearing");
        Ok(())
    }

    /// Unloads a bearing in the end, to 0.1 % of the load where the case does not say.
    ///
    /// # Errors
    /// Where the case is a general scene, which has steps of its own.
    pub fn set_unloading(&mut self) -> Result<(), CaseError> {
        let bearing = self.bearing_mut("unloading")?;
        bearing.unload_to.get_or_insert(UNLOAD_TO);
        Ok(())
    }

    /// Keeps every body elastic, whatever its steel.
    pub fn set_elastic(&mut self) {
        self.control(|controls| controls.plasticity = false);
        self.note("controls.plasticity", "false");
    }

    /// Makes every body of this hexahedron.
    pub fn set_element(&mut self, element: ElementKind) {
        self.control(|controls| controls.element = element);
    }

    /// Solves linear systems this way.
    pub fn set_solver(&mut self, solver: SolverKind) {
        self.control(|controls| controls.solver = solver);
    }

    fn control(&mut self, set: impl Fn(&mut Controls)) {
        set(&mut self.controls);
        if let Kind::General(general) = &mut self.kind {
            set(&mut general.model.controls);
        }
    }

    /// Multiplies every element size of a bearing's mesh by `scale`, the grading kept (see
    /// [`Sizes::scaled`](super::bearing::Sizes::scaled)), and those at the contact by `contact` once
    /// more.
    ///
    /// # Errors
    /// Where the sizes come out of their range, or the case is a general scene.
    pub fn scale_mesh(&mut self, scale: f64, contact: f64) -> Result<(), CaseError> {
        let bearing = self.bearing_mut("a scaled template")?;
        set_mesh(bearing, bearing.mesh.scaled(scale).sharpened(contact))
    }

    /// Multiplies groups of element sizes of a bearing's mesh.
    ///
    /// # Errors
    /// As [`scale_mesh`](Self::scale_mesh).
    pub fn refine_mesh(&mut self, scales: &Scales) -> Result<(), CaseError> {
        let bearing = self.bearing_mut("a refined template")?;
        set_mesh(bearing, bearing.mesh.refined(scales))
    }

    /// Leaves out what does not say how good a mesh is: plastic flow, and the unloading of a bearing.
    pub fn set_elastic_and_loaded(&mut self) {
        self.set_elastic();
        if let Kind::Bearing(bearing) = &mut self.kind {
            bearing.unload_to = None;
        }
    }

    /// Meshes a bearing for lines of contact of these widths, where its preset looks at them.
    pub fn set_strips(&mut self, strips: Strips) {
        if let Kind::Bearing(bearing) = &mut self.kind {
            bearing.mesh.strips = Some(strips);
        }
        if strips.found {
            let how = ", for lines of contact as wide as a solution found them";
            for assumption in self.assumptions.iter_mut() {
                if assumption.key == "mesh.preset" && !assumption.value.ends_with(how) {
                    assumption.value.push_str(how);
                }
            }
        }
    }

    /// Takes level `level` of the family that the mesh of the case belongs to; a case on a file
    /// or a template is left as it is.
    pub fn set_level(&mut self, new: u32) {
        if let Kind::General(general) = &mut self.kind
            && let MeshOrigin::Family { level, .. } = &mut general.mesh.origin
        {
            *level = new;
        }
    }

    fn bearing_mut(&mut self, what: &str) -> Result<&mut BearingCase, CaseError> {
        match &mut self.kind {
            Kind::Bearing(bearing) => Ok(bearing),
            Kind::General(_) => {
                let message = format!(
                    "{what} is for bearings; the case `{}` is a general scene on a mesh file",
                    self.title
                );
                Err(CaseError::new(ErrorKind::Conflict, message))
            }
        }
    }

    /// Keeps the echoed assumptions true.
    fn note(&mut self, key: &str, value: &str) {
        for assumption in self.assumptions.iter_mut().filter(|a| a.key == key) {
            assumption.value = value.to_string();
            assumption.why = "asked for when the case was run".to_string();
            assumption.given = true;
        }
    }
}

/// Meshes the bearing as `request` says, where it fits.
fn set_mesh(bearing: &mut BearingCase, request: MeshRequest) -> Result<(), CaseError> {
    (request.check(bearing.layout()))
        .map_err(|error| CaseError::new(ErrorKind::Value, error.to_string()))?;
    bearing.mesh = request;
    Ok(())
}
