//! A scene as a deck of keywords for CalculiX or Abaqus (`.inp`).
//!
//! The bodies must stand in touch: the deck has no other means to find the contact than soft
//! springs and, where a rigid plane is driven by force, a first step that moves it a little way.
//! Everything is in the units of the case; the deck says which.

mod contact;
mod error;
mod hold;
mod mesh;
mod names;
mod steps;

pub use error::InpError;

use crate::model::scene::{ElementKind, Scene};
use names::Names;
use std::io::{self, Write};

/// How the other program is to treat contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ContactType {
    /// Penalty at points of the faces: the one that copes with friction and plasticity.
    #[default]
    SurfaceToSurface,
    /// Penalty at the nodes of the carrier.
    NodeToSurface,
    /// Dual mortar multipliers (CalculiX). Its carrier must not be held by supports.
    Mortar,
}

/// What the deck says beyond the scene.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Settings {
    /// Of the deck, for its head.
    pub title: String,
    /// Names of the units of length, force and stress.
    pub units: [String; 3],
    /// Element type; `None` takes the one that stands for the element of the scene.
    pub element: Option<String>,
    pub contact: ContactType,
    /// Pressure per overclosure; `None` takes 20 Young's moduli over the shortest edge of the
    /// carriers' faces.
    pub contact_stiffness: Option<f64>,
    /// How far the closing step moves a plane that is driven by force; `None` takes the
    /// shortening of a solid block in place of the bodies, which is safely too little. Where no
    /// plane is driven there is no such step.
    pub closing: Option<f64>,
    /// First increment of the load steps, as a share of the step; `None` takes that of the scene.
    pub increment: Option<f64>,
    /// Linear solver; `None` leaves the choice to the program.
    pub solver: Option<String>,
}

/// The scene with what the deck needs to know of it.
struct Deck<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    names: Names,
    pairs: Vec<contact::Pair>,
    driven: Vec<hold::Driven>,
    springs: Vec<hold::Springs>,
    /// Pressure per overclosure.
    stiffness: f64,
}

/// A scene that can be written: everything that may be wrong with it has been looked for.
pub struct Checked<'a>(Deck<'a>);

/// Makes sure that `scene` can be expressed, its bodies in touch.
///
/// # Errors
/// [`InpError`] names what cannot be expressed.
pub fn check<'a>(scene: &'a Scene, settings: &'a Settings) -> Result<Checked<'a>, InpError> {
    let positive = |what, value: Option<f64>| match value {
        Some(value) if !(value > 0.0 && value.is_finite()) => {
            Err(InpError::NotPositive { what, value })
        }
        _ => Ok(()),
    };
    positive("the contact stiffness", settings.contact_stiffness)?;
    positive("the closing motion", settings.closing)?;
    positive("the first increment", settings.increment)?;
    let mut names = Names::new(&scene.mesh);
    let pairs = contact::pairs(scene, &mut names)?;
    let driven = hold::driven(scene)?;
    let springs = hold::springs(scene, &mut names);
    let stiffness = settings.contact_stiffness;
    Ok(Checked(Deck {
        stiffness: stiffness.unwrap_or_else(|| contact::default_stiffness(scene, &pairs)),
        scene,
        settings,
        names,
        pairs,
        driven,
        springs,
    }))
}

impl Checked<'_> {
    /// Writes the deck.
    ///
    /// # Errors
    /// Where `out` cannot be written.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let deck = &self.0;
        deck.head(out)?;
        deck.mesh(out)?;
        deck.steel(out)?;
        deck.contact(out)?;
        deck.hold(out)?;
        deck.steps(out)
    }
}

impl Deck<'_> {
    fn head(&self, out: &mut dyn Write) -> io::Result<()> {
        let [length, force, stress] = &self.settings.units;
        writeln!(out, "*HEADING\n{}", one_line(&self.settings.title))?;
        writeln!(out, "** Written by Brinell {}.", env!("CARGO_PKG_VERSION"))?;
        writeln!(out, "** Units: {length}, {force}, {stress}.")?;
        let axes = self.scene.mirrors.iter().filter_map(|a| "xyz".get(*a..=*a));
        let axes: Vec<&str> = axes.collect();
        if !axes.is_empty() {
            let axes = axes.join(" and ");
            writeln!(
                out,
                "** Symmetric across {axes} = 0: forces are those on the modelled part."
            )?;
        }
        if self.pairs.iter().any(|pair| pair.true_geometry) {
            writeln!(
                out,
                "** Brinell takes cylinders as round in the initial gap; here they are facets."
            )?;
        }
        Ok(())
    }

    fn steel(&self, out: &mut dyn Write) -> io::Result<()> {
        for (body, steel) in self.scene.materials.iter().enumerate() {
            let name = self.names.body(body);
            writeln!(out, "*MATERIAL,NAME={name}\n*ELASTIC")?;
            let (young, poisson) = (steel.youngs_modulus, steel.poissons_ratio);
            writeln!(out, "{},{}", number(young), number(poisson))?;
            if self.scene.controls.plasticity && !steel.is_elastic() {
                // A straight line: stress against equivalent plastic strain.
                let end = steel.yield_stress + steel.hardening_modulus;
                writeln!(out, "*PLASTIC\n{},0.", number(steel.yield_stress))?;
                writeln!(out, "{},1.", number(end))?;
            }
            writeln!(out, "*SOLID SECTION,ELSET={name},MATERIAL={name}")?;
        }
        Ok(())
    }

    /// The element type.
    fn element(&self) -> &str {
        match (&self.settings.element, self.scene.controls.element) {
            (Some(element), _) => element,
            (None, ElementKind::Enhanced) => "C3D8I",
            (None, ElementKind::Bbar | ElementKind::Full) => "C3D8",
        }
    }
}

/// A number in at most 19 characters: CalculiX reads 20.
fn number(value: f64) -> String {
    format!("{value:.12e}")
}

/// `text` without line breaks, so that it stays one line of the deck and no keyword.
fn one_line(text: &str) -> String {
    let text = text.replace(['\n', '\r'], " ");
    text.trim_start_matches([' ', '*']).to_string()
}

/// Writes `items` after each other, twelve to a line.
fn list(out: &mut dyn Write, items: impl IntoIterator<Item = usize>) -> io::Result<()> {
    let items: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    for line in items.chunks(12) {
        writeln!(out, "{},", line.join(","))?;
    }
    Ok(())
}
