//! The size of an output: by it, newtons and metres are compared.

/// The typical spread of some numbers: the distance of their tenth and ninetieth percentiles, so that a pole among them does not
/// hide the rest; where these are equal the whole range, then the size of the numbers, then 1.
pub(crate) fn spread(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = numbers.collect();
    sorted.sort_by(f64::total_cmp);
    let (Some(&least), Some(&most)) = (sorted.first(), sorted.last()) else { return 1.0 };
    let last = sorted.len() - 1;
    let (low, high) = (sorted[last / 10], sorted[last - last / 10]);
    let size = least.abs().max(most.abs());
    let is_more_than_rounding = |range: &f64| *range > 1e-12 * size && range.is_finite();
    [high - low, most - least, size].into_iter().find(is_more_than_rounding).unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pole_does_not_set_the_scale() {
        let numbers = (0..100).map(|i| if i == 50 { -1e12 } else { f64::from(i) });
        let spread = spread(numbers);
        assert!((70.0..100.0).contains(&spread), "{spread}");
    }

    #[test]
    fn of_equal_numbers_their_size_counts() {
        assert_eq!(spread([7.0, 7.0, 7.0].into_iter()), 7.0);
        assert_eq!(spread([0.0, 0.0].into_iter()), 1.0);
        assert_eq!(spread(std::iter::empty()), 1.0);
        assert_eq!(spread([-f64::MAX, f64::MAX].into_iter()), f64::MAX);
    }
}
