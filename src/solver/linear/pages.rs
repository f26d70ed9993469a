//! Storage of a factor, straight from the system and on large pages where it has them: a factor is
//! touched once a factorisation from end to end, and each small page of it costs an interrupt.

use bytemuck::Pod;
use memmap2::MmapMut;
use std::io;
use std::marker::PhantomData;
use std::ops::{Deref, DerefMut};

/// Numbers that are zero at first.
pub(super) struct Pages<T>(MmapMut, PhantomData<T>);

impl<T: Pod> Pages<T> {
    /// `count` zeros.
    ///
    /// # Errors
    /// Where memory runs out.
    pub fn new(count: usize) -> io::Result<Self> {
        let bytes = count.checked_mul(size_of::<T>());
        let map = MmapMut::map_anon(bytes.ok_or(io::ErrorKind::OutOfMemory)?)?;
        // A hint only: without large pages all is as before, but slower.
        #[cfg(target_os = "linux")]
        let _ = map.advise(memmap2::Advice::HugePage);
        Ok(Self(map, PhantomData))
    }
}

impl<T: Pod> Deref for Pages<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        bytemuck::cast_slice(&self.0)
    }
}

impl<T: Pod> DerefMut for Pages<T> {
    fn deref_mut(&mut self) -> &mut [T] {
        bytemuck::cast_slice_mut(&mut self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_zero_at_first_and_keep_what_they_are_given() {
        let mut pages = Pages::<f64>::new(1000).unwrap();
        assert!(pages.len() == 1000 && pages.iter().all(|v| *v == 0.0));
        pages[999] = 3.5;
        assert_eq!(pages[999], 3.5);
        assert!(Pages::<f64>::new(0).unwrap().is_empty());
        assert!(Pages::<f64>::new(usize::MAX).is_err());
        assert!(Pages::<f64>::new(usize::MAX / 16).is_err());
    }
}
