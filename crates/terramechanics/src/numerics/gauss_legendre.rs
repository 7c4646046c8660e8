//! Gauss–Legendre rule with 24 points, and two sums over the same points that tell how well it resolved a function.

use super::lanes::LANES;

/// Points of the rule.
pub(crate) const POINTS: usize = 24;

/// Positive half of the nodes on [−1, 1] and their weights: roots of P24 and 2/((1 − x²) P24'(x)²), found at 40 digits.
const HALF: [(f64, f64); POINTS / 2] = [
    (0.064_056_892_862_605_63, 0.127_938_195_346_752_16),
    (0.191_118_867_473_616_3, 0.125_837_456_346_828_3),
    (0.315_042_679_696_163_4, 0.121_670_472_927_803_39),
    (0.433_793_507_626_045_1, 0.115_505_668_053_725_6),
    (0.545_421_471_388_839_5, 0.107_444_270_115_965_63),
    (0.648_093_651_936_975_6, 0.097_618_652_104_113_89),
    (0.740_124_191_578_554_4, 0.086_190_161_531_953_28),
    (0.820_001_985_973_903, 0.073_346_481_411_080_31),
    (0.886_415_527_004_401, 0.059_298_584_915_436_78),
    (0.938_274_552_002_732_8, 0.044_277_438_817_419_81),
    (0.974_728_555_971_309_5, 0.028_531_388_628_933_663),
    (0.995_187_219_997_021_4, 0.012_341_229_799_987_2),
];

/// One node of the rule on [0, 1].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Node {
    /// Place in [0, 1].
    pub(crate) place: f64,
    /// Weight; the weights add up to 1.
    pub(crate) weight: f64,
    /// P23 and P22 at the node: weighted sums of a function with them are its highest Legendre coefficients that the rule
    /// can see, and vanish as fast as the function is resolved.
    pub(crate) null: [f64; 2],
}

/// The rule on [0, 1].
pub(crate) const NODES: [Node; POINTS] = nodes();

const fn nodes() -> [Node; POINTS] {
    let mut nodes = [Node { place: 0.0, weight: 0.0, null: [0.0; 2] }; POINTS];
    let mut i = 0;
    while i < POINTS / 2 {
        let (x, weight) = HALF[i];
        nodes[POINTS / 2 + i] = node(x, weight);
        nodes[POINTS / 2 - 1 - i] = node(-x, weight);
        i += 1;
    }
    nodes
}

const fn node(x: f64, weight: f64) -> Node {
    // (k + 1) P_{k+1} = (2k + 1) x P_k − k P_{k−1}
    let (mut before, mut legendre) = (1.0, x);
    let mut k = 1.0;
    while k < (POINTS - 1) as f64 {
        (before, legendre) = (legendre, ((2.0 * k + 1.0) * x * legendre - k * before) / (k + 1.0));
        k += 1.0;
    }
    Node { place: 0.5 * (1.0 + x), weight: 0.5 * weight, null: [legendre, before] }
}

/// Nodes of a rule side by side.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LaneNodes {
    pub(crate) place: [f64; LANES],
    pub(crate) weight: [f64; LANES],
    pub(crate) null: [[f64; LANES]; 2],
}

/// [`NODES`] side by side.
pub(crate) const FINE: [LaneNodes; POINTS / LANES] = {
    let mut fine = [LaneNodes { place: [0.0; LANES], weight: [0.0; LANES], null: [[0.0; LANES]; 2] }; POINTS / LANES];
    let mut i = 0;
    while i < POINTS {
        let (nodes, lane) = (&mut fine[i / LANES], i % LANES);
        nodes.place[lane] = NODES[i].place;
        nodes.weight[lane] = NODES[i].weight;
        nodes.null[0][lane] = NODES[i].null[0];
        nodes.null[1][lane] = NODES[i].null[1];
        i += 1;
    }
    fine
};

/// Positive half of the nodes of the rule with 8 points, and their weights: roots of P8, found at 40 digits.
const COARSE_HALF: [(f64, f64); LANES / 2] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_2, 0.101_228_536_290_376_26),
];

/// The rule with 8 points on [0, 1], for a first look. It does not tell how well it resolved a function.
pub(crate) const COARSE: [LaneNodes; 1] = {
    let mut nodes = LaneNodes { place: [0.0; LANES], weight: [0.0; LANES], null: [[0.0; LANES]; 2] };
    let mut i = 0;
    while i < LANES / 2 {
        let (x, weight) = COARSE_HALF[i];
        (nodes.place[LANES / 2 + i], nodes.weight[LANES / 2 + i]) = (0.5 * (1.0 + x), 0.5 * weight);
        (nodes.place[LANES / 2 - 1 - i], nodes.weight[LANES / 2 - 1 - i]) = (0.5 * (1.0 - x), 0.5 * weight);
        i += 1;
    }
    [nodes]
};

#[cfg(test)]
mod tests {
    use super::*;

    fn sum(f: impl Fn(&Node) -> f64) -> f64 {
        NODES.iter().map(f).sum()
    }

    #[test]
    fn polynomials_up_to_degree_47_are_integrated_exactly() {
        for degree in 0..=47 {
            let exact = 1.0 / f64::from(degree + 1);
            assert!((sum(|n| n.weight * n.place.powi(degree)) - exact).abs() < 1e-15, "{degree}");
        }
    }

    #[test]
    fn the_null_sums_vanish_on_low_degrees_and_see_their_own() {
        for degree in 0..=21 {
            for k in 0..2 {
                assert!(sum(|n| n.weight * n.null[k] * (2.0 * n.place - 1.0).powi(degree)).abs() < 1e-15);
            }
        }
        // ∫ P_k² over [0, 1] in the shifted variable is 1/(2k + 1).
        assert!((sum(|n| n.weight * n.null[0] * n.null[0]) - 1.0 / 47.0).abs() < 1e-15);
        assert!((sum(|n| n.weight * n.null[1] * n.null[1]) - 1.0 / 45.0).abs() < 1e-15);
    }

    #[test]
    fn the_coarse_rule_integrates_polynomials_up_to_degree_15_exactly() {
        let [nodes] = &COARSE;
        for degree in 0..=15 {
            let sum: f64 = nodes.place.iter().zip(&nodes.weight).map(|(x, weight)| weight * x.powi(degree)).sum();
            assert!((sum - 1.0 / f64::from(degree + 1)).abs() < 1e-15, "{degree}");
        }
    }
}
