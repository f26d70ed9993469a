//! Errors on logarithmic axes, as figures.

use super::peers::Peers;
use super::study::{Curve, Reference, Study, StudyLevel};
use crate::render::plot::{Line, Panel, PlotFigure, Scale};

/// What the dashed level of a panel is.
const FLOOR: &str = "uncertainty of the reference: errors below it mean nothing";
/// What a level is drawn against.
type Abscissa = fn(&StudyLevel) -> f64;

/// More quantities than this are drawn against one axis only.
const MANY: usize = 12;
/// Smaller errors are drawn as this, in percent.
const LEAST: f64 = 1e-3;

/// Every quantity with errors, against unknowns on the left and CPU seconds on the right; where
/// they are many, against CPU seconds only.
pub fn figure(study: &Study) -> PlotFigure {
    let curves = study.curves();
    let elements = study.elements();
    let mut panels = Vec::new();
    let many = study.quantities.len() > MANY;
    for quantity in &study.quantities {
        let of: Vec<&Curve> = curves
            .iter()
            .filter(|c| c.quantity == quantity.name)
            .collect();
        let axes: [(&'static str, Abscissa); 2] = [
            ("unknowns", |l| l.dofs as f64),
            ("CPU seconds", |l| l.cost.cpu_s),
        ];
        for (x, at) in axes.into_iter().skip(usize::from(many)) {
            let lines = of.iter().filter_map(|c| own_line(study, &elements, c, at));
            panels.push(Panel {
                title: format!("{}, error in %", quantity.name),
                axes: [x.to_string(), String::new()],
                scale: Scale::Decades,
                lines: lines.collect(),
                dashed: of.first().and_then(|c| floor(c)).into_iter().collect(),
            });
        }
    }
    panels.retain(|p| p.lines.iter().any(|l| !l.points.is_empty()));
    PlotFigure {
        panels,
        legend: own_names(&elements),
        dashed: FLOOR.to_string(),
    }
}

/// Problem H against CPU seconds, with the stored results of other programs.
pub fn figure_with_peers(study: &Study, peers: &Peers) -> PlotFigure {
    const SHOWN: [&str; 6] = [
        "p0",
        "half-width",
        "Mises block, integration point",
        "Mises cylinder, integration point",
        "Mises block, nodal",
        "Mises cylinder, nodal",
    ];
    let curves = study.curves();
    let elements = study.elements();
    let mut panels = Vec::new();
    for name in SHOWN {
        let of = || curves.iter().filter(|c| c.quantity == name);
        let mut lines: Vec<Line> = of()
            .filter_map(|c| own_line(study, &elements, c, |l| l.cost.cpu_s))
            .collect();
        for (k, peer) in peers.curves.iter().enumerate() {
            let point = |row: &super::peers::PeerRow| {
                Some((row.cpu_s, percent(row.error_percent.of(name)?)))
            };
            let points = peer.rows.iter().filter_map(point);
            lines.push(Line::dotted(elements.len() + k, points.collect()));
        }
        panels.push(Panel {
            title: format!("{name}, error in %"),
            axes: ["CPU seconds".to_string(), String::new()],
            scale: Scale::Decades,
            lines,
            dashed: of().next().and_then(floor).into_iter().collect(),
        });
    }
    let mut legend = own_names(&elements);
    legend.extend(peers.curves.iter().map(|p| p.name()));
    PlotFigure {
        panels,
        legend,
        dashed: FLOOR.to_string(),
    }
}

fn own_names(elements: &[&str]) -> Vec<String> {
    let name = |e: &&str| format!("Brinell, {e}");
    elements.iter().map(name).collect()
}

fn percent(error: f64) -> f64 {
    (100.0 * error.abs()).max(LEAST)
}

fn floor(curve: &Curve) -> Option<f64> {
    match curve.reference {
        Some(Reference::Known { within, .. }) if within > 0.0 => Some(100.0 * within),
        _ => None,
    }
}

fn own_line(
    study: &Study,
    elements: &[&str],
    curve: &Curve,
    at: impl Fn(&StudyLevel) -> f64,
) -> Option<Line> {
    let levels = study.levels_of(curve.element);
    let points = levels.iter().zip(&curve.errors);
    let style = elements.iter().position(|e| *e == curve.element)?;
    let shown = points
        .filter_map(|(level, error)| Some((at(level), percent((*error)?))))
        .filter(|(x, _)| *x > 0.0);
    Some(Line::dotted(style, shown.collect()))
}

#[cfg(test)]
mod tests {
    use super::super::peers::peers;
    use super::super::sample::study;
    use super::*;
    use crate::render::plot::svg;

    #[test]
    fn a_figure_has_its_lines_and_its_legend() {
        let figure = figure(&study());
        assert_eq!(figure.panels.len(), 6);
        assert_eq!(figure.panels[0].lines[0].points.len(), 3);
        let text = svg(&figure).unwrap();
        assert!(text.starts_with("<svg") && text.contains("Brinell, bbar"));
    }

    #[test]
    fn other_programs_stand_beside() {
        let figure = figure_with_peers(&study(), &peers().unwrap());
        assert_eq!(figure.legend.len(), 5);
        assert!(svg(&figure).unwrap().contains("CalculiX"));
    }

    #[test]
    fn nothing_to_draw_is_an_empty_figure() {
        let empty = figure(&Study::new("none", "none".into()));
        assert!(empty.panels.is_empty() && svg(&empty).is_ok());
    }
}
