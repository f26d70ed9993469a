//! Numbers in binary: four-byte and eight-byte integers, eight-byte floating point.

use super::cursor::Cursor;
use super::error::MeshError;

impl Cursor<'_> {
    fn take<const N: usize>(&mut self, expected: &str) -> Result<[u8; N], MeshError> {
        match self.rest().first_chunk::<N>() {
            Some(bytes) => {
                self.offset += N;
                Ok(*bytes)
            }
            None => Err(self.truncated(expected)),
        }
    }

    pub(super) fn binary_int(&mut self, big: bool, expected: &str) -> Result<i64, MeshError> {
        let bytes = self.take(expected)?;
        let value = if big {
            i32::from_be_bytes(bytes)
        } else {
            i32::from_le_bytes(bytes)
        };
        Ok(i64::from(value))
    }

    pub(super) fn binary_size(&mut self, big: bool, expected: &str) -> Result<u64, MeshError> {
        let bytes = self.take(expected)?;
        Ok(if big {
            u64::from_be_bytes(bytes)
        } else {
            u64::from_le_bytes(bytes)
        })
    }

    pub(super) fn binary_real(&mut self, big: bool, expected: &str) -> Result<f64, MeshError> {
        let bytes = self.take(expected)?;
        Ok(if big {
            f64::from_be_bytes(bytes)
        } else {
            f64::from_le_bytes(bytes)
        })
    }
}
