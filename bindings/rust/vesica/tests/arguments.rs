// SPDX-License-Identifier: Apache-2.0
//! What is refused, what layouts are taken, that nothing is copied, and that any arguments are survived.
use vesica::*;

fn disc(cx: f64, r: f64) -> Circle<f64> {
    Circle { cx, cy: 0.0, r }
}

#[test]
fn invalid_shapes() {
    let bad = disc(0.0, -1.0);
    assert_eq!(overlap(&bad, &disc(0.0, 1.0)), Err(Error::Shape));
    assert_eq!(check(&bad), Err(Error::NegativeSize));
    assert!(Error::Shape.to_string().starts_with("a shape is invalid"));
    let discs = [disc(0.0, 1.0), bad, disc(9.0, 1.0), disc(1.0, f64::NAN)];
    let mut hits = [true; 4];
    assert_eq!(overlap_many(&discs, &disc(1.0, 1.0), &mut hits), Err(Error::Shape));
    assert_eq!(hits, [true, false, false, false]);
}

/// After an error -1 tells how many are kept of the valid shapes.
#[test]
fn kept_beside_invalid_shapes() {
    let (discs, scores) =
        ([disc(0.0, 1.0), disc(0.0, -1.0), disc(9.0, 1.0), disc(20.0, 1.0)], [1.0, 4.0, 2.0, f64::NAN]);
    let mut scratch = vec![0; nms_scratch(4).unwrap()];
    let mut keep = [7; 5];
    assert_eq!(nms(&discs, &scores, 0.5, &mut scratch, &mut keep), Err(Error::Shape));
    assert_eq!(keep, [2, 0, -1, 7, 7]);
    let by_iou = Suppression::by_iou(0.5);
    let mut keep = [7; 4];
    assert_eq!(suppress(&discs, &scores, by_iou, &mut scratch, &mut keep), Err(Error::Shape));
    assert_eq!(keep, [2, 0, -1, 7]);
    let (mut keep, two) = ([7; 2], Suppression { most: 2, ..by_iou });
    assert_eq!(suppress(&discs, &scores, two, &mut scratch, &mut keep), Err(Error::Shape));
    assert_eq!(keep, [2, 0]);
    // After another error nothing is written.
    let (mut keep, wrong) = ([7; 4], Suppression::by_iou(2.0));
    assert_eq!(suppress(&discs, &scores, wrong, &mut scratch, &mut keep), Err(Error::Argument));
    assert_eq!(keep, [7; 4]);
    let (decay, ratio) = (Decay::Linear(0.5), Ratio::OverUnion);
    let how = SoftSuppression { decay, ratio, labels: &[], least_score: 0.0, most: 4 };
    let mut scratch = vec![0; suppress_soft_scratch(4).unwrap()];
    let (mut keep, mut left) = ([7; 4], [0.5; 4]);
    assert_eq!(suppress_soft(&discs, &scores, how, &mut scratch, &mut keep, &mut left), Err(Error::Shape));
    assert_eq!((keep, left[..2].to_vec()), ([2, 0, -1, 7], vec![2.0, 1.0]));
}

#[test]
fn counts_and_room() {
    let three = [disc(0.0, 1.0); 3];
    let mut hits = [false; 3];
    let error = overlap_many(&three, &three[..2], &mut hits).unwrap_err();
    assert_eq!(error, Error::Counts(3, 2));
    assert_eq!(error.to_string(), "3 shapes and 2: as many are needed, or one of either");
    let error = overlap_matrix(&three, &three, &mut hits).unwrap_err();
    assert_eq!(error, Error::Room { needed: 9, given: 3 });
    assert_eq!(error.to_string(), "an output of 3 elements, where 9 are needed");
    assert!(Shapes::packed(Kind::Circle, &[1.0, 2.0]).is_err());
    assert!(Shapes::columns(Kind::Point, &[&[1.0], &[1.0, 2.0]]).is_err());
    let steps = [usize::MAX, usize::MAX / 2, isize::MAX as usize / 8 + 1, isize::MAX as usize / 8, 3, 2];
    let none = steps.map(|step| Shapes::<f64>::records(Kind::Circle, &[], step).map(|shapes| shapes.len()).ok());
    assert_eq!(none, [None, None, None, Some(0), Some(0), None]);
    assert!(AnyShape::new(Kind::Point, &[1.0]).is_err());
    assert!(nearest_many(&three, &three, ClosestPointsColumns::default()).is_err());
    assert_eq!(nms(&three, &[1.0], 0.5, &mut [], &mut []), Err(Error::Counts(3, 1)));
    assert_eq!(nms(&three, &[1.0; 3], 0.5, &mut [], &mut [0; 3]).err().map(Error::code), Some(-4));
}

#[test]
fn nothing_at_all() {
    let none: [Circle<f64>; 0] = [];
    assert_eq!(overlap_many(&none, &disc(0.0, 1.0), &mut []), Ok(0));
    assert_eq!(overlap_matrix(&none, &none, &mut []), Ok(0));
    let index = Index::new(&[Shapes::from(&none)]).unwrap();
    assert!(index.is_empty());
    assert_eq!(index.select(&disc(0.0, 1.0)), Ok(vec![]));
    assert_eq!(index.nearest(&disc(0.0, 1.0), 3, f64::INFINITY), Ok(vec![]));
    assert_eq!(index.join(&index, JoinQuery::Overlap), Ok(vec![]));
    assert!(Index::<f64>::new(&[]).unwrap().is_empty());
}

#[test]
fn layouts() {
    let records = [0.0, 0.0, 1.0, 77.0, 5.0, 0.0, 1.0, 77.0];
    let by_records = Shapes::records(Kind::Circle, &records, 4).unwrap();
    let by_columns = Shapes::columns(Kind::Circle, &[&[0.0, 5.0], &[0.0, 0.0], &[1.0, 1.0]]).unwrap();
    let mut relations = [Relation::Disjoint; 2];
    assert_eq!(relation_many(by_records, by_columns, &mut relations), Ok(2));
    assert_eq!(relations, [Relation::Equal; 2]);
    let mut distances = [0.0; 2];
    let only = ClosestPointsColumns { distance: &mut distances, ..Default::default() };
    assert_eq!(nearest_many(by_records, &disc(2.5, 1.0), only), Ok(0));
    assert_eq!(distances, [0.5; 2]);
}

#[test]
fn indexes_refuse_foreign_bytes_and_other_sets() {
    let discs = [disc(0.0, 1.0), disc(1.0, 1.0), disc(9.0, -1.0)];
    let index = Index::new(&[Shapes::from(&discs)]).unwrap();
    assert!(index.incomplete());
    assert_eq!(index.join(&index, JoinQuery::Overlap), Ok(vec![(0, 1)]));
    let sets = [Shapes::from(&discs)];
    assert_eq!(Index::from_bytes(&[1; 640], &sets).err(), Some(Error::Index));
    let (bytes, fewer) = (index.as_bytes(), [Shapes::from(&discs[..2])]);
    assert_eq!(Index::from_bytes(&bytes[..bytes.len() - 64], &sets).err(), Some(Error::Index));
    assert_eq!(Index::from_bytes(bytes, &fewer).err(), Some(Error::Counts(3, 2)));
    assert_eq!(index.join_part(&index, JoinQuery::Overlap, 2, 2), Err(Error::Argument));
}

/// The first shape of some numbers, or an error if there is none.
fn single(kind: Kind, numbers: &[f64]) -> Result<AnyShape<f64>, Error> {
    AnyShape::new(kind, numbers.get(..kind.fields()).unwrap_or(numbers))
}

/// Whatever is passed, there is an answer or an error. Every question is answered now and then.
#[test]
fn any_arguments() {
    const QUESTIONS: usize = 23;
    let calls: usize = std::env::var("VESICA_CALLS").map_or(5_000, |text| text.parse().unwrap());
    let special = [0.0, -0.0, 1.0, -1.0, 0.5, f64::NAN, f64::INFINITY, 5e-324, 1.7e308, 1e-200];
    let kinds = [
        Kind::Point,
        Kind::Segment,
        Kind::Circle,
        Kind::Aabb,
        Kind::Rect,
        Kind::Ellipse,
        Kind::Capsule,
        Kind::RoundRect,
    ];
    let seed = std::process::id() as u64;
    println!("seed {seed}");
    let mut state = seed;
    let mut draw = move |below: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize % below
    };
    let mut answered = [0; QUESTIONS];
    for _ in 0..calls {
        // Capsules and rounded rectangles come seldom: many questions are not for them.
        let most = if draw(4) == 0 { 8 } else { 6 };
        let (kind_a, kind_b, room, step) = (kinds[draw(most)], kinds[draw(most)], draw(100), draw(9));
        let mut numbers = |kind: Kind| -> Vec<f64> {
            let count = if draw(4) == 0 { draw(40) } else { kind.fields() * draw(6) };
            (0..count).map(|_| if draw(40) == 0 { special[draw(special.len())] } else { draw(9) as f64 }).collect()
        };
        let (first, second) = (numbers(kind_a), numbers(kind_b));
        let a = if draw(3) > 0 { Shapes::packed(kind_a, &first) } else { Shapes::records(kind_a, &first, step) };
        let (a, b) = match (a, Shapes::packed(kind_b, &second)) {
            (Ok(a), Ok(b)) => (a, b),
            _ => continue,
        };
        let (one, two) = (single(kind_a, &first), single(kind_b, &second));
        let scores = second.get(..a.len()).unwrap_or(&second);
        let (mut bools, mut out, mut items) = (vec![false; room], vec![0.0; room], vec![0; room]);
        // One element is missing now and then.
        let less = draw(6) / 5;
        let mut scratch = vec![0; nms_scratch(a.len()).unwrap().saturating_sub(less)];
        let mut soft_scratch = vec![0; suppress_soft_scratch(a.len()).unwrap().saturating_sub(less)];
        let velocity = &scores[..scores.len().min(1 + draw(40))];
        let (question, number, other) = (draw(QUESTIONS), special[draw(10)], special[draw(10)]);
        let motion = Motion { vx: number, vy: draw(5) as f64 - 2.0, t_end: other };
        let mut turn = || Turn { vx: draw(9) as f64 - 4.0, vy: draw(5) as f64 - 2.0, angle: special[draw(10)] };
        let turns = (turn(), turn());
        let code = match question {
            0 => overlap_many(a, b, &mut bools),
            1 => contains_matrix(a, b, &mut bools),
            2 => area_many(a, b, &mut out),
            3 => iou_matrix(a, b, &mut out),
            4 => depth_many(a, b, PenetrationColumns { depth: &mut out, ..Default::default() }),
            5 => nearest_many(a, b, ClosestPointsColumns { by: &mut out, ..Default::default() }),
            6 => nms(a, scores, number, &mut scratch, &mut items),
            7 => Index::new(&[a, b]).and_then(|index| index.join_count(&index, JoinQuery::Contains)),
            8 => Index::new(&[a]).and_then(|index| nearest_of_each(&[b], &index, step, 1e300, &mut items, &mut out)),
            9 => ratio_many(Ratio::Complete, a, b, &mut out),
            10 => depth_matrix(a, b, &mut out),
            11 => boxes_from_shapes(a, Angle::QUARTERS.reversed(), &mut vec![[0.0; 5]; room]).map(|()| 0),
            12 => cast_many(a, b, (velocity, velocity), other, ImpactColumns { y: &mut out, ..Default::default() }),
            13 => one.and_then(|one| cast_first(&one, b, motion)).map(|_| 0),
            14 => {
                let labels = vec![1; a.len().max(draw(4))];
                let how = Suppression { labels: &labels, most: room, ..Suppression::by_iou(0.5) };
                suppress(a, scores, how, &mut scratch, &mut items)
            }
            15 => within_matrix(a, b, number, &mut vec![Within::No; room]),
            16 => one.and_then(|one| intersection(&one, &two?)).map(|region| region.vertices().len()),
            17 => {
                let (decay, ratio) = (Decay::Gaussian(number), Ratio::Generalized);
                let how = SoftSuppression { decay, ratio, labels: &[], least_score: 0.0, most: draw(9) };
                suppress_soft(a, scores, how, &mut soft_scratch, &mut items, &mut out)
            }
            18 => signed_distance_many(a, b, &mut out),
            19 => one
                .and_then(|one| de9im(&one, &two?))
                .and_then(|matrix| de9im_match(&matrix, [&b"T*F**FFF*"[..], b"0123T*F**", b"T*"][draw(3)]))
                .map(|fits| fits as usize),
            20 => one.and_then(|one| cast(&one, &two?, motion)).map(|(found, ..)| found as usize),
            21 => {
                one.and_then(|one| impact_time(&one, turns.0, &two?, turns.1, number)).map(|(found, ..)| found as usize)
            }
            _ => Index::from_bytes(&vec![draw(255) as u8; draw(900)], &[a])
                .and_then(|index| index.join_count(&index, JoinQuery::Bounds)),
        };
        answered[question] += code.is_ok() as usize;
    }
    println!("answered: {answered:?} of {calls}");
    // Random bytes are no index.
    assert!(calls < 5_000 || answered[..QUESTIONS - 1].iter().all(|&count| count > 0), "{answered:?} of {calls}");
}
