//! Storage of a factor, straight from the system and on large pages where it has them: a factor is
//! touched once a factorisation from end to end, and each small page of it costs an interrupt.

use memmap2::MmapMut;
use std::io;
use std::ops::{Deref, DerefMut};

/// Numbers that are zero at first.
pub struct Pages(MmapMut);

impl Pages {
    /// `count` zeros.
    ///
    /// # Errors
    /// Where memory runs out.
    pub fn new(count: usize) -> io::Result<Self> {
        let bytes = count.checked_mul(size_of::<f64>());
        let map = MmapMut::map_anon(bytes.ok_or(io::ErrorKind::OutOfMemory)?)?;
        // A hint only: without large pages all is as before, but slower.
        #[cfg(target_os = "linux")]
        let _ = map.advise(memmap2::Advice::HugePage);
        Ok(Self(map))
    }
}

impl Deref for Pages {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        bytemuck::cast_slice(&self.0)
    }
}

impl DerefMut for Pages {
    fn deref_mut(&mut self) -> &mut [f64] {
        bytemuck::cast_slice_mut(&mut self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_zero_at_first_and_keep_what_they_are_given() {
        let mut pages = Pages::new(1000).unwrap();
        assert!(pages.len() == 1000 && pages.iter().all(|v| *v == 0.0));
        pages[999] = 3.5;
        assert_eq!(pages[999], 3.5);
        assert!(Pages::new(0).unwrap().is_empty());
        assert!(Pages::new(usize::MAX).is_err());
        assert!(Pages::new(usize::MAX / 16).is_err());
    }
}
