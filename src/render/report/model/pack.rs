//! Numbers for the page, small: 16 or 32 bits, each as the difference from one before, their bytes
//! sorted by weight, deflated, in base64.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::io::{self, Write};

/// Arrays one behind the other, in the order in which the page takes them out again.
#[derive(Debug, Clone, Default)]
pub struct Packed {
    bytes: Vec<u8>,
}

impl Packed {
    /// Adds 16-bit numbers.
    pub fn short(&mut self, values: &[u16]) {
        let mut before = 0u16;
        let changes = values.iter().map(|value| {
            let change = value.wrapping_sub(before);
            before = *value;
            change.to_le_bytes()
        });
        self.sorted(&changes.collect::<Vec<_>>());
    }

    /// Adds groups of node numbers, each as the difference from its like in the group before: along
    /// a row of elements that is mostly one.
    pub fn groups<const N: usize>(&mut self, groups: &[[u32; N]]) {
        for corner in 0..N {
            let mut before = 0u32;
            let changes = groups.iter().map(|group| {
                let change = group[corner].wrapping_sub(before);
                before = group[corner];
                change.to_le_bytes()
            });
            self.sorted(&changes.collect::<Vec<_>>());
        }
    }

    /// All lowest bytes first: what repeats comes to stand together.
    fn sorted<const B: usize>(&mut self, values: &[[u8; B]]) {
        for byte in 0..B {
            self.bytes.extend(values.iter().map(|v| v[byte]));
        }
    }

    /// The arrays, deflated, in base64.
    ///
    /// # Errors
    /// Where compressing fails, which it does for want of memory only.
    pub fn text(self) -> io::Result<String> {
        let mut encoder = ZlibEncoder::new(Vec::new(), Compression::new(7));
        encoder.write_all(&self.bytes)?;
        Ok(STANDARD.encode(encoder.finish()?))
    }
}

/// `value` between `low` and `high`, as one of 65536 steps.
pub fn quantised(value: f64, low: f64, high: f64) -> u16 {
    let share = if high > low {
        (value - low) / (high - low)
    } else {
        0.0
    };
    // What is not a number becomes zero.
    (share.clamp(0.0, 1.0) * 65535.0).round() as u16
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::read::ZlibDecoder;
    use std::io::Read;

    fn bytes(packed: Packed) -> Vec<u8> {
        let deflated = STANDARD.decode(packed.text().unwrap()).unwrap();
        let mut bytes = Vec::new();
        ZlibDecoder::new(deflated.as_slice())
            .read_to_end(&mut bytes)
            .unwrap();
        bytes
    }

    #[test]
    fn numbers_come_as_differences_with_their_bytes_sorted() {
        let mut packed = Packed::default();
        packed.short(&[258, 259, 1]);
        packed.groups(&[[7, 9], [8, 10]]);
        let expected = [
            2, 1, 254, 1, 0, 254, // 258, +1, -258
            7, 1, 0, 0, 0, 0, 0, 0, // 7, +1
            9, 1, 0, 0, 0, 0, 0, 0, // 9, +1
        ];
        assert_eq!(bytes(packed), expected);
    }

    #[test]
    fn steps_reach_from_end_to_end() {
        assert_eq!(quantised(-1.0, -1.0, 3.0), 0);
        assert_eq!(quantised(3.0, -1.0, 3.0), 65535);
        assert_eq!(quantised(f64::NAN, 0.0, 1.0), 0);
        assert_eq!(quantised(5.0, 5.0, 5.0), 0);
    }
}
