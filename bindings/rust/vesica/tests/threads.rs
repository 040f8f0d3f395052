// SPDX-License-Identifier: Apache-2.0
//! Indexes and joins by any number of threads: the same bytes and pairs.
use vesica::*;

fn scattered(mut state: u64, n: usize) -> Vec<Rect<f64>> {
    let mut next = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 40) as f64 / (1u64 << 24) as f64
    };
    (0..n).map(|_| Rect { cx: 300.0 * next(), cy: 300.0 * next(), ux: 1.0, uy: next(), hx: 0.5, hy: 0.3 }).collect()
}

#[test]
fn any_number_of_threads() {
    let (a, mut b) = (scattered(1, 60_000), scattered(2, 70_000));
    b[7].hx = -1.0;
    let sets = ([a[..].into()], [b[..].into()]);
    let (alone, other) = (Index::new(&sets.0).unwrap(), Index::new(&sets.1).unwrap());
    let pairs = alone.join(&other, JoinQuery::Overlap).unwrap();
    assert_eq!(pairs.len(), alone.join_count(&other, JoinQuery::Overlap).unwrap());
    assert!(pairs.len() > 60_000);
    for threads in 0..6 {
        let first = Index::new_parallel(&sets.0, threads).unwrap();
        let second = Index::new_parallel(&sets.1, threads).unwrap();
        assert!(first.as_bytes() == alone.as_bytes() && second.as_bytes() == other.as_bytes(), "{threads}");
        assert!(!first.incomplete() && second.incomplete());
        assert!(first.join_parallel(&second, JoinQuery::Overlap, threads).unwrap() == pairs, "{threads}");
    }
}

#[test]
fn little_or_nothing() {
    let none = Index::<f32>::new_parallel(&[], 4).unwrap();
    assert_eq!(none.join_parallel(&none, JoinQuery::Overlap, 4), Ok(vec![]));
    let discs = [Circle { cx: 0.0f32, cy: 0.0, r: 1.0 }, Circle { cx: 1.0, cy: 0.0, r: 1.0 }];
    let few = Index::new_parallel(&[discs[..].into()], 7).unwrap();
    assert_eq!(few.join_parallel(&few, JoinQuery::Overlap, 7), Ok(vec![(0, 1)]));
}
