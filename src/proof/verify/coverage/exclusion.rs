//! Claims of two meshes that exclude each other: no true value is needed to know that one of them is wrong.

use super::measure::ClaimRecord;
use std::collections::BTreeMap;

/// Two claims of one figure, on two meshes.
pub struct ClaimPair<'r>([&'r ClaimRecord; 2]);

impl<'r> ClaimPair<'r> {
    /// All pairs of claims that have bars.
    pub fn all(records: &'r [ClaimRecord]) -> Vec<Self> {
        let mut figures: BTreeMap<_, Vec<&ClaimRecord>> = BTreeMap::new();
        for record in records.iter().filter(|r| r.reading.bar.is_some()) {
            let reading = &record.reading;
            let figure = (
                &record.bearing,
                record.elastic,
                &reading.what,
                &reading.place,
            );
            figures.entry(figure).or_default().push(record);
        }
        let mut pairs = Vec::new();
        for claims in figures.values() {
            for (i, a) in claims.iter().enumerate() {
                pairs.extend(claims[i + 1..].iter().map(|b| Self([a, b])));
            }
        }
        pairs
    }

    /// Distance of the values over the sum of the bars.
    pub fn distance(&self) -> f64 {
        let [a, b] = self.0.map(|record| &record.reading);
        let bars = a.bar.unwrap_or(f64::INFINITY) + b.bar.unwrap_or(f64::INFINITY);
        (a.value - b.value).abs() / bars
    }

    pub fn exclude_each_other(&self) -> bool {
        self.distance() > 1.0
    }

    /// The two records.
    pub fn records(&self) -> [&'r ClaimRecord; 2] {
        self.0
    }
}

/// The share of pairs that exclude each other. Of independent bars that hold in 95 of 100 cases these are 0.6 of 100 where
/// both are alike, and 5 where one is much the narrower.
pub fn share_excluded(records: &[ClaimRecord]) -> Option<f64> {
    let pairs = ClaimPair::all(records);
    let excluded = pairs
        .iter()
        .filter(|pair| pair.exclude_each_other())
        .count();
    (!pairs.is_empty()).then(|| excluded as f64 / pairs.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::super::measure::BarVerdict;
    use super::super::solution::ClaimReading;
    use super::*;

    fn claim(preset: &str, value: f64, bar: Option<f64>) -> ClaimRecord {
        ClaimRecord {
            bearing: "centre".into(),
            preset: preset.into(),
            elastic: true,
            reading: ClaimReading {
                what: "descent".into(),
                place: "overall".into(),
                value,
                bar,
                note: None,
            },
            truth: None,
            verdict: BarVerdict::Unknown,
            compared: false,
            strip: None,
            unknowns: 0,
            cpu_s: 0.0,
        }
    }

    #[test]
    fn bars_that_do_not_meet_exclude_each_other() {
        let records = [
            claim("h025", 10.0, Some(1.0)),
            claim("h0125", 11.9, Some(1.0)),
            claim("auto", 12.5, Some(1.0)),
            claim("report-like", 99.0, None),
        ];
        let distances: Vec<f64> = ClaimPair::all(&records)
            .iter()
            .map(ClaimPair::distance)
            .collect();
        assert_eq!(distances.len(), 3);
        assert_eq!(share_excluded(&records), Some(1.0 / 3.0));
        assert_eq!(share_excluded(&records[3..]), None);
    }
}
