//! The head of a deck, and its materials.

use super::deck::Deck;
use super::format::{number, one_line};
use crate::model::scene::ElementKind;
use std::io::{self, Write};

impl Deck<'_> {
    pub(super) fn head(&self, out: &mut dyn Write) -> io::Result<()> {
        let [length, force, stress] = &self.settings.units;
        writeln!(out, "*HEADING\n{}", one_line(&self.settings.title))?;
        writeln!(out, "** Written by Brinell {}.", env!("CARGO_PKG_VERSION"))?;
        writeln!(out, "** Units: {length}, {force}, {stress}.")?;
        if self.scene.controls.element == ElementKind::Bbar && self.element() == "C3D8" {
            writeln!(
                out,
                "** The case is solved with B-bar hexahedra; C3D8 is stiffer in bending. To compare the same\n\
                 ** element, set `element = \"full\"` in [controls] of the case."
            )?;
        }
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

    pub(super) fn steel(&self, out: &mut dyn Write) -> io::Result<()> {
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
            if let Some(expansion) = self.heat.expansions.get(&body) {
                writeln!(out, "*EXPANSION\n{}", number(*expansion))?;
            }
            writeln!(out, "*SOLID SECTION,ELSET={name},MATERIAL={name}")?;
        }
        if !self.heat.expansions.is_empty() {
            writeln!(out, "*INITIAL CONDITIONS,TYPE=TEMPERATURE\nNALL,0.")?;
        }
        Ok(())
    }
}
