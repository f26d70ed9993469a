//! The value below which a share of a list lies.

/// The value below which a share of the list lies, interpolated; none of an empty list.
pub fn quantile(mut list: Vec<f64>, share: f64) -> Option<f64> {
    list.sort_by(f64::total_cmp);
    let at = share * list.len().checked_sub(1)? as f64;
    let (low, high) = (at.floor() as usize, at.ceil() as usize);
    Some(list[low] + (at - low as f64) * (list[high] - list[low]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_lie_between_the_values() {
        assert_eq!(quantile(vec![], 0.5), None);
        assert_eq!(quantile(vec![3.0], 0.9), Some(3.0));
        assert_eq!(quantile(vec![3.0, 1.0, 2.0], 0.5), Some(2.0));
        assert_eq!(quantile(vec![0.0, 1.0], 0.9), Some(0.9));
    }
}
