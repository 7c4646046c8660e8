//! Points that fill the unit cube evenly: an additive recurrence whose steps are powers of the inverse of the generalised golden
//! ratio, the root of x^(d+1) = x + 1 (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018). For one
//! dimension it is the golden ratio. The seed shifts all points alike.

/// The points, without an end.
#[derive(Debug, Clone)]
pub(crate) struct Sequence {
    steps: Vec<f64>,
    next: Vec<f64>,
}

impl Sequence {
    pub(crate) fn new(dimensions: usize, seed: u64) -> Self {
        let ratio = generalised_golden_ratio(dimensions);
        let steps = (1..=dimensions).map(|i| ratio.powi(-(i as i32))).collect();
        let mut state = seed;
        let next = (0..dimensions).map(|_| uniform(&mut state)).collect();
        Self { steps, next }
    }
}

impl Iterator for Sequence {
    type Item = Vec<f64>;

    fn next(&mut self) -> Option<Vec<f64>> {
        let point = self.next.clone();
        for (place, step) in self.next.iter_mut().zip(&self.steps) {
            *place = (*place + step).fract();
        }
        Some(point)
    }
}

/// The fixed point of x = (1 + x)^(1/(d+1)), a contraction.
fn generalised_golden_ratio(dimensions: usize) -> f64 {
    let exponent = 1.0 / (dimensions as f64 + 1.0);
    (0..64).fold(2.0_f64, |x, _| (1.0 + x).powf(exponent))
}

/// The next number from 0 to below 1 of SplitMix64 (Steele, Lea and Flood 2014).
fn uniform(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ratios_are_the_golden_and_the_plastic_number() {
        assert!((generalised_golden_ratio(1) - f64::midpoint(1.0, 5.0_f64.sqrt())).abs() < 1e-15);
        assert!((generalised_golden_ratio(2) - 1.324_717_957_244_746).abs() < 1e-15); // the real root of x³ = x + 1
    }

    #[test]
    fn each_cell_of_a_grid_gets_nearly_its_share_of_the_points() {
        for seed in 0..20 {
            let mut counts = [0_u32; 16];
            for point in Sequence::new(2, seed).take(256) {
                counts[(4.0 * point[0]) as usize + 4 * (4.0 * point[1]) as usize] += 1;
            }
            // Independent points would differ from 16 by 4, and by 8 or more in one of these cells.
            assert!(counts.iter().all(|&count| (12..=20).contains(&count)), "{seed}: {counts:?}");
        }
    }

    #[test]
    fn another_seed_gives_other_points() {
        assert_eq!(Sequence::new(3, 1).next(), Sequence::new(3, 1).next());
        assert_ne!(Sequence::new(3, 1).next(), Sequence::new(3, 2).next());
    }
}
