//! Arrays as VTK's XML files hold them: zlib blocks behind a header, in base64.

use std::borrow::Cow;
use std::io::{self, Write};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use rayon::prelude::*;

/// Bytes in a block before compression; blocks are compressed independently.
const BLOCK_BYTES: usize = 1 << 17;

/// Faster by far than the default level, at nearly its size on doubles.
const COMPRESSION_LEVEL: u32 = 3;

/// The values of an array, one after the other.
#[derive(Debug, Clone, PartialEq)]
pub enum Values<'a> {
    F64(Cow<'a, [f64]>),
    I64(Cow<'a, [i64]>),
    I32(Cow<'a, [i32]>),
    U8(Cow<'a, [u8]>),
}

impl Values<'_> {
    /// VTK's name of the type.
    pub fn type_name(&self) -> &'static str {
        match self {
            Self::F64(_) => "Float64",
            Self::I64(_) => "Int64",
            Self::I32(_) => "Int32",
            Self::U8(_) => "UInt8",
        }
    }

    /// How many values there are.
    pub fn len(&self) -> usize {
        match self {
            Self::F64(v) => v.len(),
            Self::I64(v) => v.len(),
            Self::I32(v) => v.len(),
            Self::U8(v) => v.len(),
        }
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn blocks(&self) -> io::Result<Vec<Vec<u8>>> {
        match self {
            Self::F64(v) => compress(v, |x| x.to_le_bytes()),
            Self::I64(v) => compress(v, |x| x.to_le_bytes()),
            Self::I32(v) => compress(v, |x| x.to_le_bytes()),
            Self::U8(v) => compress(v, |x| [*x]),
        }
    }

    fn bytes(&self) -> usize {
        let size = match self {
            Self::F64(_) | Self::I64(_) => 8,
            Self::I32(_) => 4,
            Self::U8(_) => 1,
        };
        size * self.len()
    }

    /// Writes the values as the content of an inline binary `DataArray` of a little-endian file
    /// with `UInt64` headers and `vtkZLibDataCompressor`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let blocks = self.blocks()?;
        // Number of blocks, bytes in a block, bytes in a last partial block or zero, then the
        // compressed bytes of each.
        let mut header = vec![
            blocks.len() as u64,
            BLOCK_BYTES as u64,
            (self.bytes() % BLOCK_BYTES) as u64,
        ];
        header.extend(blocks.iter().map(|b| b.len() as u64));
        let header: Vec<u8> = header.iter().flat_map(|n| n.to_le_bytes()).collect();
        out.write_all(STANDARD.encode(header).as_bytes())?;
        // One run of base64 over all blocks: a block's end need not be a multiple of three.
        let mut encoder = base64::write::EncoderWriter::new(out, &STANDARD);
        for block in &blocks {
            encoder.write_all(block)?;
        }
        encoder.finish().map(|_| ())
    }
}

/// Compresses the values block by block; the result does not depend on the number of threads.
fn compress<T: Sync, const N: usize>(
    values: &[T],
    bytes: impl Fn(&T) -> [u8; N] + Sync,
) -> io::Result<Vec<Vec<u8>>> {
    values
        .par_chunks(BLOCK_BYTES / N)
        .map(|chunk| {
            let raw: Vec<u8> = chunk.iter().flat_map(&bytes).collect();
            let mut encoder = ZlibEncoder::new(Vec::new(), Compression::new(COMPRESSION_LEVEL));
            encoder.write_all(&raw)?;
            encoder.finish()
        })
        .collect()
}
