//! Polygons with a value at each corner, painted into a PNG.

use super::colours;
use crate::ground::geometry::range;
use crate::render::OutputError;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use std::path::Path;

/// A convex polygon: place of each corner in pixels, from the upper left, and the share of the
/// range that its value has.
pub type Corner = ([f64; 2], f64);

/// A picture of one byte a pixel: a step of the colour map, or nothing.
#[derive(Debug, Clone)]
pub struct Raster {
    width: usize,
    height: usize,
    steps: Vec<u8>,
}

/// The byte of a pixel that shows nothing.
const NOTHING: u8 = 0;

impl Raster {
    pub fn new(width: usize, height: usize) -> Self {
        Self {
            width,
            height,
            steps: vec![NOTHING; width * height],
        }
    }

    /// Paints a polygon, its value straight across the triangles of a fan.
    pub fn paint(&mut self, corners: &[Corner]) {
        let Some((first, rest)) = corners.split_first() else {
            return;
        };
        for pair in rest.windows(2) {
            self.triangle([*first, pair[0], pair[1]]);
        }
    }

    fn triangle(&mut self, [a, b, c]: [Corner; 3]) {
        let cross = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
            (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        };
        let area = cross(a.0, b.0, c.0);
        if area == 0.0 || !area.is_finite() {
            return;
        }
        let span = |k: usize, end: usize| {
            let [low, high] = range([a, b, c].map(|corner| corner.0[k]));
            low.floor().max(0.0) as usize..(high.ceil().max(0.0) as usize).min(end)
        };
        for row in span(1, self.height) {
            for column in span(0, self.width) {
                let at = [column as f64 + 0.5, row as f64 + 0.5];
                let weights = [
                    cross(at, b.0, c.0) / area,
                    cross(at, c.0, a.0) / area,
                    cross(at, a.0, b.0) / area,
                ];
                // A pixel on the seam of two triangles belongs to both.
                if weights.iter().all(|w| *w >= -1e-9) {
                    let value = weights[0] * a.1 + weights[1] * b.1 + weights[2] * c.1;
                    self.steps[row * self.width + column] = step(value);
                }
            }
        }
    }

    /// The picture as the address of an image that holds it itself.
    ///
    /// # Errors
    /// [`OutputError::Plot`] where it cannot be encoded.
    pub fn address(&self) -> Result<String, OutputError> {
        let png = self.png().map_err(|error| OutputError::Plot {
            path: Path::new(super::super::FILE).to_path_buf(),
            why: error.to_string(),
        })?;
        Ok(format!("data:image/png;base64,{}", STANDARD.encode(png)))
    }

    fn png(&self) -> Result<Vec<u8>, png::EncodingError> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_depth(png::BitDepth::Eight);
        let mut palette = colours::table();
        palette[usize::from(NOTHING)] = [255; 3];
        encoder.set_palette(palette.into_flattened());
        encoder.set_trns(vec![0]);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.steps)?;
        writer.finish()?;
        Ok(bytes)
    }
}

/// The step of the colour map at a share of the range.
fn step(share: f64) -> u8 {
    1 + (share.clamp(0.0, 1.0) * 254.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_is_painted_from_edge_to_edge() {
        let mut raster = Raster::new(8, 8);
        let corner = |x: f64, y: f64| ([x, y], x / 8.0);
        let square = [(2.0, 1.0), (6.0, 1.0), (6.0, 7.0), (2.0, 7.0)].map(|(x, y)| corner(x, y));
        raster.paint(&square);
        let painted = raster.steps.iter().filter(|s| **s != NOTHING).count();
        assert_eq!(painted, 4 * 6);
        let row = &raster.steps[3 * 8..4 * 8];
        assert_eq!((row[1], row[6]), (NOTHING, NOTHING));
        assert!(row[2] < row[3] && row[4] < row[5]);
        assert!(raster.png().unwrap().starts_with(b"\x89PNG"));
    }
}
