//! Lists in order.

/// Things in ascending order, each once.
pub fn ascending<T: Ord>(things: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut all: Vec<T> = things.into_iter().collect();
    all.sort_unstable();
    all.dedup();
    all
}
