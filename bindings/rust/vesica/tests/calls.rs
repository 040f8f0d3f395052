// SPDX-License-Identifier: Apache-2.0
//! The calls that all packages answer alike (bindings/calls/calls.txt), and that wrong answers among them are found.
use std::collections::HashSet;
use vesica::*;

/// What a call gives: its result, or its error's code, and the values.
type Outcome = Result<(i64, Vec<f64>), (i32, Vec<f64>)>;

trait Number: Scalar + Into<f64> + From<f32> {
    fn of(number: f64) -> Self;
}
impl Number for f64 {
    fn of(number: f64) -> f64 {
        number
    }
}
impl Number for f32 {
    fn of(number: f64) -> f32 {
        number as f32
    }
}

fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(if exponent < -1022 { 1 << (exponent + 1074) } else { ((exponent + 1023) as u64) << 52 })
}

/// A hexadecimal float of C's, or whatever Rust reads.
fn number(word: &str) -> f64 {
    let (sign, digits) = word.strip_prefix('-').map_or((1.0, word), |rest| (-1.0, rest));
    let (mantissa, exponent) = match digits.strip_prefix("0x").and_then(|hex| hex.split_once('p')) {
        Some(parts) => parts,
        None => return word.parse().unwrap(),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let bits = u64::from_str_radix(&format!("{whole}{fraction}"), 16).unwrap();
    let exponent = exponent.parse::<i32>().unwrap() - 4 * fraction.len() as i32;
    sign * bits as f64 * power_of_two(exponent)
}

struct Call<'a> {
    function: &'a str,
    arguments: Vec<&'a str>,
}

fn kind_of(word: &str) -> Option<Kind> {
    let names = ["point", "segment", "circle", "aabb", "rect", "ellipse"];
    let kinds = [Kind::Point, Kind::Segment, Kind::Circle, Kind::Aabb, Kind::Rect, Kind::Ellipse];
    names.iter().position(|name| *name == word).map(|i| kinds[i])
}

fn numbers<T: Number>(text: &str) -> Vec<T> {
    text.split_whitespace().filter(|word| kind_of(word).is_none()).map(|word| T::of(number(word))).collect()
}

fn values<T: Number>(numbers: &[T]) -> Vec<f64> {
    numbers.iter().map(|&number| number.into()).collect()
}

/// The numbers of several sets, for as long as their shapes are in use.
struct Sets<T>(Vec<(Kind, Vec<T>)>);

impl<T: Number> Sets<T> {
    fn of(arguments: &[&str]) -> Self {
        Sets(arguments.iter().map(|text| (kind_of(first_word(text)).unwrap(), numbers(text))).collect())
    }
    fn shapes(&self) -> Vec<Shapes<'_, T>> {
        self.0.iter().map(|(kind, numbers)| Shapes::packed(*kind, numbers).unwrap()).collect()
    }
    fn single(&self, i: usize) -> AnyShape<T> {
        AnyShape::new(self.0[i].0, &self.0[i].1).unwrap()
    }
}

fn first_word(text: &str) -> &str {
    text.split_whitespace().next().unwrap()
}

/// A result that is all there is, or nothing: of calls that write nothing on error.
fn whole(result: Result<(i64, Vec<f64>), Error>) -> Outcome {
    result.map_err(|error| (error.code(), vec![]))
}

/// A count or an error, and columns that are written either way.
fn written(result: Result<usize, Error>, values: Vec<f64>) -> Outcome {
    match result {
        Ok(count) => Ok((count as i64, values)),
        Err(error) => Err((error.code(), values)),
    }
}

fn impact<T: Number>(i: Impact<T>) -> Vec<f64> {
    values(&[i.t, i.x, i.y, i.nx, i.ny])
}

/// What was met first, as the library tells it.
fn first<T: Number>(found: Option<(usize, Impact<T>)>, none: usize) -> (i64, Vec<f64>) {
    let nothing = Impact { t: f64::INFINITY, x: f64::NAN, y: f64::NAN, nx: f64::NAN, ny: f64::NAN };
    found.map_or((none as i64, impact(nothing)), |(item, met)| (item as i64, impact(met)))
}

fn turn<T: Number>(text: &str) -> Turn<T> {
    let n = numbers(text);
    Turn { vx: n[0], vy: n[1], angle: n[2] }
}

fn of_turns<T: Number>(call: &Call) -> Outcome {
    let (sets, tolerance) = (Sets::<T>::of(&[call.arguments[0], call.arguments[2]]), numbers(call.arguments[4])[0]);
    let (turn_a, turn_b) = (turn(call.arguments[1]), turn(call.arguments[3]));
    whole(
        impact_time(&sets.single(0), turn_a, &sets.single(1), turn_b, tolerance)
            .map(|(found, met, gap)| (found as i64, [impact(met), values(&[gap])].concat())),
    )
}

fn of_motion<T: Number>(call: &Call) -> Option<Outcome> {
    if call.function == "impact_time" {
        return Some(of_turns::<T>(call));
    }
    let (of, shapes) = match call.function {
        "cast" | "cast_first" => (2, 0..2),
        "cast_many" => (4, 0..2),
        "sweep_bounds" | "index_cast" | "index_cast_first" => (1, 0..1),
        _ => return None,
    };
    let n = numbers::<T>(call.arguments[of]);
    let sets = Sets::<T>::of(&call.arguments[shapes]);
    if call.function == "cast_many" {
        let (a, b) = (sets.shapes()[0], sets.shapes()[1]);
        let (vx, vy, count) = (numbers(call.arguments[2]), numbers(call.arguments[3]), a.len().max(b.len()));
        let mut columns = vec![T::of(0.0); 5 * count];
        let mut column = columns.chunks_mut(count);
        let mut next = || column.next().unwrap();
        let out = ImpactColumns { t: next(), x: next(), y: next(), nx: next(), ny: next() };
        let result = cast_many(a, b, (&vx, &vy), n[0], out);
        return Some(written(result, values(&columns)));
    }
    let (one, motion) = (sets.single(0), Motion { vx: n[0], vy: n[1], t_end: n[2] });
    Some(whole(match call.function {
        "cast" => cast(&one, &sets.single(1), motion).map(|(found, met)| (found as i64, impact(met))),
        "cast_first" => cast_first(&one, sets.shapes()[1], motion).map(|found| first(found, sets.shapes()[1].len())),
        "sweep_bounds" => sweep_bounds(&one, motion).map(|b| (0, values(&[b.min_x, b.min_y, b.max_x, b.max_y]))),
        _ => {
            let sets = Sets::<T>::of(&call.arguments[2..]);
            let index = Index::new(&sets.shapes()).unwrap();
            if call.function == "index_cast_first" {
                index.cast_first(&one, motion).map(|found| first(found, index.len()))
            } else {
                let items = index.cast(&one, motion);
                items.map(|items| (items.len() as i64, items.into_iter().map(|item| item as f64).collect()))
            }
        }
    }))
}

fn rows<T: Number, const N: usize>(rows: &[[T; N]]) -> Vec<f64> {
    rows.iter().flat_map(|row| values(row)).collect()
}

fn angle(unit: &str) -> Angle {
    let unit = unit.trim().parse::<i32>().unwrap();
    let measure = [Angle::RADIANS, Angle::DEGREES, Angle::QUARTERS][(unit % 4) as usize];
    if unit < 4 {
        measure
    } else {
        measure.reversed()
    }
}

fn of_boxes<T: Number>(call: &Call) -> Option<Outcome> {
    let done = |result: Result<(), Error>| result.map(|()| 0);
    if let "rects_from_boxes" | "ellipses_from_boxes" = call.function {
        let numbers = numbers::<T>(call.arguments[0]);
        let boxes: Vec<[T; 5]> = numbers.chunks(5).map(|row| row.try_into().unwrap()).collect();
        let (mut rects, mut ellipses) = (vec![Rect::default(); boxes.len()], vec![Ellipse::default(); boxes.len()]);
        let angle = angle(call.arguments[1]);
        return Some(if call.function == "rects_from_boxes" {
            let result = done(rects_from_boxes(&boxes, angle, &mut rects));
            written(result, rects.iter().flat_map(|rect| values(rect.numbers())).collect())
        } else {
            let result = done(ellipses_from_boxes(&boxes, angle, &mut ellipses));
            written(result, ellipses.iter().flat_map(|ellipse| values(ellipse.numbers())).collect())
        });
    }
    if !matches!(call.function, "boxes_from_shapes" | "corners_of_shapes" | "bounds_many") {
        return None;
    }
    let sets = Sets::<T>::of(&call.arguments[..1]);
    let shapes = sets.shapes()[0];
    let (mut boxes, mut corners) = (vec![[T::of(0.0); 5]; shapes.len()], vec![[T::of(0.0); 8]; shapes.len()]);
    let mut bounds = vec![Aabb::default(); shapes.len()];
    Some(match call.function {
        "boxes_from_shapes" => {
            let result = done(boxes_from_shapes(shapes, angle(call.arguments[1]), &mut boxes));
            written(result, rows(&boxes))
        }
        "corners_of_shapes" => {
            let result = done(corners_of_shapes(shapes, &mut corners));
            written(result, rows(&corners))
        }
        _ => {
            let result = done(bounds_many(shapes, &mut bounds));
            written(result, bounds.iter().flat_map(|b| values(b.numbers())).collect())
        }
    })
}

fn ratio_of(text: &str) -> Ratio {
    let ratios = [
        Ratio::OverUnion,
        Ratio::OverFirst,
        Ratio::OverSecond,
        Ratio::OverSmaller,
        Ratio::Generalized,
        Ratio::Distance,
        Ratio::Complete,
    ];
    ratios[number(text.trim()) as usize]
}

fn of_ratios<T: Number>(call: &Call) -> Outcome {
    let (which, sets) = (ratio_of(call.arguments[0]), Sets::<T>::of(&call.arguments[1..]));
    let (a, b) = (sets.shapes()[0], sets.shapes()[1]);
    let mut out = vec![T::of(0.0); a.len() * b.len()];
    match call.function {
        "ratio" => whole(ratio(which, &sets.single(0), &sets.single(1)).map(|ratio| (0, values(&[ratio])))),
        "ratio_many" => {
            out.truncate(a.len().max(b.len()));
            let result = ratio_many(which, a, b, &mut out);
            written(result, values(&out))
        }
        _ => {
            let result = ratio_matrix(which, a, b, &mut out);
            written(result, values(&out))
        }
    }
}

fn of_topology<T: Number>(call: &Call) -> Option<Outcome> {
    if call.function == "de9im_match" {
        let (matrix, pattern) = (call.arguments[0].as_bytes(), call.arguments[1].trim().as_bytes());
        return Some(whole(de9im_match(matrix, pattern).map(|yes| (yes.into(), vec![]))));
    }
    if call.function == "join_within" {
        let mut parts = call.arguments[1..].split(|text| *text == "/");
        let sets_a = Sets::<T>::of(parts.next().unwrap());
        let sets_b = Sets::<T>::of(parts.next().unwrap());
        let (a, b) = (Index::new(&sets_a.shapes()).unwrap(), Index::new(&sets_b.shapes()).unwrap());
        let other = if sets_b.0.is_empty() { &a } else { &b };
        return Some(whole(
            a.join_within(other, numbers(call.arguments[0])[0])
                .map(|pairs| (pairs.len() as i64, pairs.into_iter().flat_map(|(a, b)| [a as f64, b as f64]).collect())),
        ));
    }
    if call.function == "suppress_soft" {
        return Some(softly::<T>(call));
    }
    if !matches!(call.function, "within" | "within_many" | "within_matrix" | "de9im" | "intersection") {
        return None;
    }
    let sets = Sets::<T>::of(&call.arguments[..2]);
    let (a, b) = (sets.shapes()[0], sets.shapes()[1]);
    if let "within_many" | "within_matrix" = call.function {
        let (is_matrix, distance) = (call.function == "within_matrix", numbers(call.arguments[2])[0]);
        let count = if is_matrix { a.len() * b.len() } else { a.len().max(b.len()) };
        let mut out = vec![Within::No; count];
        let result =
            if is_matrix { within_matrix(a, b, distance, &mut out) } else { within_many(a, b, distance, &mut out) };
        return Some(written(result, out.into_iter().map(|each| f64::from(each as u8)).collect()));
    }
    let (a, b) = (sets.single(0), sets.single(1));
    Some(whole(match call.function {
        "within" => within(&a, &b, numbers(call.arguments[2])[0]).map(|found| (found as i64, vec![])),
        "de9im" => de9im(&a, &b).map(|matrix| {
            (0, matrix.iter().map(|&letter| if letter == b'F' { -1.0 } else { f64::from(letter - b'0') }).collect())
        }),
        _ => intersection(&a, &b).map(|region| (region.vertices().len() as i64, rows(region.vertices()))),
    }))
}

fn softly<T: Number>(call: &Call) -> Outcome {
    let sets = Sets::<T>::of(&call.arguments[..1]);
    let (shapes, scores) = (sets.shapes()[0], numbers::<T>(call.arguments[1]));
    let how = numbers::<T>(call.arguments[2]);
    let labels = call.arguments.get(3).map_or(vec![], |text| numbers::<T>(text));
    let labels: Vec<i32> = labels.into_iter().map(|label| label.into() as i32).collect();
    let decay = if how[1].into() == 0.0 { Decay::Linear(how[2]) } else { Decay::Gaussian(how[2]) };
    let (least_score, most) = (how[3], how[4].into() as usize);
    let how = SoftSuppression { decay, ratio: Ratio::OverUnion, labels: &labels, least_score, most };
    let mut scratch = vec![0; suppress_soft_scratch(shapes.len()).unwrap()];
    let (mut keep, mut left) = (vec![0; shapes.len()], vec![T::of(0.0); shapes.len()]);
    let result = suppress_soft(shapes, &scores, how, &mut scratch, &mut keep, &mut left);
    let kept = kept(result, &keep);
    let left = values(&left[..kept.len()]);
    written(result.map(|_| 0), kept.into_iter().chain(left).collect())
}

/// The indices kept: as many as the result is, after an error up to -1.
fn kept(result: Result<usize, Error>, keep: &[i64]) -> Vec<f64> {
    let count = result.unwrap_or_else(|_| keep.iter().position(|&i| i < 0).unwrap_or(keep.len()));
    keep[..count].iter().map(|&i| i as f64).collect()
}

fn suppressed<T: Number>(call: &Call) -> Outcome {
    let sets = Sets::<T>::of(&call.arguments[..1]);
    let (shapes, scores) = (sets.shapes()[0], numbers::<T>(call.arguments[1]));
    let how: Vec<&str> = call.arguments[2].split_whitespace().collect();
    let labels = call.arguments.get(3).map_or(vec![], |text| numbers::<T>(text));
    let labels: Vec<i32> = labels.into_iter().map(|label| label.into() as i32).collect();
    let how = Suppression {
        ratio: ratio_of(how[0]),
        threshold: T::of(number(how[1])),
        least_score: Some(T::of(number(how[2]))).filter(|&least| least.into() > f64::NEG_INFINITY),
        most: number(how[3]) as usize,
        labels: &labels,
    };
    let mut scratch = vec![0; nms_scratch(shapes.len()).unwrap()];
    let mut keep = vec![0; shapes.len()];
    let result = suppress(shapes, &scores, how, &mut scratch, &mut keep);
    written(result.map(|_| 0), kept(result, &keep))
}

fn of_one_or_two<T: Number>(call: &Call) -> Option<Outcome> {
    let sets = Sets::<T>::of(&call.arguments);
    let a = sets.single(0);
    let b = if call.arguments.len() > 1 { sets.single(1) } else { a };
    let closest =
        |points: ClosestPoints<T>| (0, values(&[points.distance, points.ax, points.ay, points.bx, points.by]));
    Some(whole(match call.function {
        "overlap" => overlap(&a, &b).map(|yes| (yes.into(), vec![])),
        "interiors_overlap" => interiors_overlap(&a, &b).map(|yes| (yes.into(), vec![])),
        "relation" => relation(&a, &b).map(|relation| (relation as i64, vec![])),
        "contains" => contains(&a, &b).map(|yes| (yes.into(), vec![])),
        "nearest" => nearest(&a, &b).map(closest),
        "boundary_distance" => boundary_distance(&a, &b).map(closest),
        "depth" => depth(&a, &b).map(|depth| (0, values(&[depth.depth, depth.x, depth.y]))),
        "signed_distance" => signed_distance(&a, &b).map(|distance| (0, values(&[distance]))),
        "area" => area(&a, &b).map(|area| (0, values(&[area]))),
        "iou" => iou(&a, &b).map(|iou| (0, values(&[iou]))),
        "check" => check(&a).map(|()| (0, vec![])),
        "shape_area" => shape_area(&a).map(|area| (0, values(&[area]))),
        "bounds" => bounds(&a).map(|b| (0, values(&[b.min_x, b.min_y, b.max_x, b.max_y]))),
        "crossings" => crossings(&a, &b).map(|places| {
            let each = places.places().iter().flatten().map(|&number| number.into());
            let shared = f64::from(u8::from(places.shared));
            (places.places().len() as i64, [shared].into_iter().chain(each).collect())
        }),
        _ => return None,
    }))
}

fn constructor<T: Number>(call: &Call) -> Option<Outcome> {
    let n = numbers::<T>(call.arguments[0]);
    let made = |shape: &dyn Shape<Scalar = T>| (0, values(shape.numbers()));
    Some(whole(match call.function {
        "aabb_from_corners" => aabb(n[0], n[1], n[2], n[3]).map(|shape| made(&shape)),
        "rect_from_angle" => rect(n[0], n[1], n[2], n[3], n[4]).map(|shape| made(&shape)),
        "rect_from_corners" => rect_from_corners(n[..].try_into().unwrap()).map(|shape| made(&shape)),
        "rect_corners_misfit" => {
            let r = numbers::<T>(call.arguments[1]);
            let rect = Rect { cx: r[0], cy: r[1], ux: r[2], uy: r[3], hx: r[4], hy: r[5] };
            rect_corners_misfit(n[..].try_into().unwrap(), &rect).map(|misfit| (0, values(&[misfit])))
        }
        "round_rect_from_angle" => round_rect(n[0], n[1], n[2], n[3], n[4], n[5]).map(|shape| made(&shape)),
        "capsule_from_angle" => capsule(n[0], n[1], n[2], n[3], n[4]).map(|shape| made(&shape)),
        "capsule_from_width" => capsule_from_width(n[0], n[1], n[2], n[3], n[4]).map(|shape| made(&shape)),
        "ellipse_from_angle" => ellipse(n[0], n[1], n[2], n[3], n[4]).map(|shape| made(&shape)),
        "ellipse_from_radius_vector" => {
            ellipse_from_radius_vector(n[0], n[1], n[2], n[3], n[4]).map(|shape| made(&shape))
        }
        "ellipse_from_covariance" => {
            ellipse_from_covariance(n[0], n[1], n[2], n[3], n[4], n[5]).map(|shape| made(&shape))
        }
        "ellipse_from_matrix" => ellipse_from_matrix(n[0], n[1], n[2], n[3], n[4]).map(|shape| made(&shape)),
        _ => return None,
    }))
}

fn of_arrays<T: Number>(call: &Call) -> Option<Outcome> {
    let sets = Sets::<T>::of(&call.arguments);
    let (a, b) = (sets.shapes()[0], sets.shapes()[1]);
    let is_matrix = call.function.ends_with("_matrix");
    let count = if is_matrix { a.len() * b.len() } else { a.len().max(b.len()) };
    let (mut bools, mut relations) = (vec![false; count], vec![Relation::Disjoint; count]);
    let mut columns = vec![T::of(0.0); 5 * count];
    let yes = |result, bools: Vec<bool>| written(result, bools.into_iter().map(|yes| f64::from(yes as u8)).collect());
    let how = |result, relations: Vec<Relation>| {
        written(result, relations.into_iter().map(|relation| f64::from(relation as u8)).collect())
    };
    let mut column = columns.chunks_mut(count);
    let mut next = || column.next().unwrap();
    let (result, used) = match call.function {
        "overlap_many" => return Some(yes(overlap_many(a, b, &mut bools), bools)),
        "interiors_overlap_many" => return Some(yes(interiors_overlap_many(a, b, &mut bools), bools)),
        "contains_many" => return Some(yes(contains_many(a, b, &mut bools), bools)),
        "relation_many" => return Some(how(relation_many(a, b, &mut relations), relations)),
        "overlap_matrix" => return Some(yes(overlap_matrix(a, b, &mut bools), bools)),
        "interiors_overlap_matrix" => return Some(yes(interiors_overlap_matrix(a, b, &mut bools), bools)),
        "contains_matrix" => return Some(yes(contains_matrix(a, b, &mut bools), bools)),
        "relation_matrix" => return Some(how(relation_matrix(a, b, &mut relations), relations)),
        "area_many" => (area_many(a, b, next()), 1),
        "iou_many" => (iou_many(a, b, next()), 1),
        "signed_distance_many" => (signed_distance_many(a, b, next()), 1),
        "signed_distance_matrix" => (signed_distance_matrix(a, b, next()), 1),
        "area_matrix" => (area_matrix(a, b, next()), 1),
        "iou_matrix" => (iou_matrix(a, b, next()), 1),
        "nearest_matrix" => (nearest_matrix(a, b, next()), 1),
        "boundary_distance_matrix" => (boundary_distance_matrix(a, b, next()), 1),
        "depth_matrix" => (depth_matrix(a, b, next()), 1),
        "depth_many" => (depth_many(a, b, PenetrationColumns { depth: next(), x: next(), y: next() }), 3),
        "nearest_many" | "boundary_distance_many" => {
            let out = ClosestPointsColumns { distance: next(), ax: next(), ay: next(), bx: next(), by: next() };
            let result = if call.function == "nearest_many" {
                nearest_many(a, b, out)
            } else {
                boundary_distance_many(a, b, out)
            };
            (result, 5)
        }
        "overlap_select" | "interiors_overlap_select" => {
            let mut out = vec![-1; b.len() + 1];
            let one = sets.single(0);
            let result = if call.function == "overlap_select" {
                overlap_select(&one, b, &mut out)
            } else {
                interiors_overlap_select(&one, b, &mut out)
            };
            let indices = out.iter().take_while(|&&i| i >= 0);
            return Some(written(result, indices.map(|&i| i as f64).collect()));
        }
        _ => return None,
    };
    Some(written(result, values(&columns[..used * count])))
}

fn suppression<T: Number>(call: &Call) -> Outcome {
    let sets = Sets::<T>::of(&call.arguments[..1]);
    let (shapes, scores) = (sets.shapes()[0], numbers::<T>(call.arguments[1]));
    let mut scratch = vec![0; nms_scratch(shapes.len()).unwrap()];
    let mut keep = vec![0; shapes.len()];
    let result = nms(shapes, &scores, numbers(call.arguments[2])[0], &mut scratch, &mut keep);
    written(result.map(|_| 0), kept(result, &keep))
}

fn k_and_within<T: Number>(text: &str) -> (usize, T) {
    let numbers = numbers::<T>(text);
    (numbers[0].into() as usize, numbers[1])
}

fn of_indexes<T: Number>(call: &Call) -> Option<Outcome> {
    let (leading, rest) = match call.function {
        "index_select" | "join" | "join_nearest" => call.arguments.split_at(1),
        "index_nearest" => call.arguments.split_at(2),
        "index_bounds" | "index_order" => call.arguments.split_at(0),
        _ => return None,
    };
    let parts: Vec<Vec<&str>> = rest.split(|text| *text == "/").map(<[_]>::to_vec).collect();
    let (sets_a, sets_b) = (Sets::<T>::of(&parts[0]), Sets::<T>::of(parts.get(1).map_or(&[][..], |part| part)));
    let a = Index::new(&sets_a.shapes()).unwrap();
    let a = Index::from_bytes(a.as_bytes(), &sets_a.shapes()).unwrap();
    let items = |items: Vec<i64>| (items.len() as i64, items.into_iter().map(|i| i as f64).collect());
    Some(match call.function {
        "index_bounds" => whole(a.bounds().map(|b| (0, vec![b.min_x, b.min_y, b.max_x, b.max_y]))),
        "index_order" => whole(a.order().map(items)),
        "index_select" => whole(a.select(&Sets::<T>::of(leading).single(0)).map(items)),
        "index_nearest" => {
            let (k, within) = k_and_within::<T>(leading[1]);
            whole(a.nearest(&Sets::<T>::of(&leading[..1]).single(0), k, within).map(|found| {
                let items = found.iter().map(|&(item, _)| item as f64);
                (found.len() as i64, items.chain(found.iter().map(|&(_, distance)| distance.into())).collect())
            }))
        }
        "join" => {
            let query = match number(leading[0]) as i32 {
                0 => JoinQuery::Overlap,
                1 => JoinQuery::Bounds,
                2 => JoinQuery::Contains,
                3 => JoinQuery::Inside,
                _ => JoinQuery::Interiors,
            };
            let b = Index::new(&sets_b.shapes()).unwrap();
            let b = if sets_b.0.is_empty() { &a } else { &b };
            assert_eq!(a.join_count(b, query), a.join(b, query).map(|pairs| pairs.len()));
            whole(
                a.join(b, query).map(|pairs| {
                    (pairs.len() as i64, pairs.into_iter().flat_map(|(a, b)| [a as f64, b as f64]).collect())
                }),
            )
        }
        _ => {
            let (k, within) = k_and_within::<T>(leading[0]);
            let b = Index::new(&sets_b.shapes()).unwrap();
            let (mut out, mut distances) = (vec![0; a.len() * k], vec![T::of(0.0); a.len() * k]);
            let result = nearest_of_each(&sets_a.shapes(), &b, k, within, &mut out, &mut distances);
            written(result, out.iter().map(|&i| i as f64).chain(values(&distances)).collect())
        }
    })
}

fn answer<T: Number>(call: &Call) -> Outcome {
    if let Some(outcome) = of_boxes::<T>(call).or_else(|| of_motion::<T>(call)) {
        return outcome;
    }
    if call.function.starts_with("ratio") {
        return of_ratios::<T>(call);
    }
    if let Some(outcome) = of_topology::<T>(call) {
        return outcome;
    }
    if call.function == "suppress" {
        return suppressed::<T>(call);
    }
    if call.function.contains("_from_") || call.function == "rect_corners_misfit" {
        return constructor::<T>(call).unwrap();
    }
    if call.function == "nms" {
        return suppression::<T>(call);
    }
    let many = ["_many", "_matrix", "_select"].iter().any(|end| call.function.ends_with(end));
    let by_index = of_indexes::<T>(call);
    by_index.or_else(|| if many { of_arrays::<T>(call) } else { of_one_or_two::<T>(call) }).expect(call.function)
}

fn code_of(word: &str) -> Option<i32> {
    let names = [
        "E_NULL",
        "E_SHAPE",
        "E_KIND",
        "E_ARGUMENT",
        "E_NOT_FINITE",
        "E_NEGATIVE_SIZE",
        "E_ZERO_AXIS",
        "E_INVERTED",
        "E_RANGE",
        "E_INDEX",
    ];
    names.iter().position(|name| *name == word).map(|i| -1 - i as i32)
}

fn same(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()))
}

fn is_right(line: &str) -> bool {
    let (left, right) = line.split_once(" = ").unwrap();
    let mut parts = left.split(" | ");
    let (function, scalar) = parts.next().unwrap().split_once(' ').unwrap();
    let call = Call { function, arguments: parts.collect() };
    let outcome = if scalar == "f64" { answer::<f64>(&call) } else { answer::<f32>(&call) };
    let mut words = right.split_whitespace();
    let result = words.next().unwrap();
    let expected: Vec<f64> = words.map(number).collect();
    match outcome {
        Ok((code, values)) => result.parse() == Ok(code as f64) && same(&values, &expected),
        Err((code, values)) => code_of(result) == Some(code) && (same(&values, &expected) || expected.is_empty()),
    }
}

fn lines() -> Vec<String> {
    let path = std::env::var("VESICA_CALLS_FILE")
        .unwrap_or_else(|_| concat!(env!("CARGO_MANIFEST_DIR"), "/../../calls/calls.txt").into());
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    text.lines().filter(|line| !line.starts_with('#')).map(String::from).collect()
}

#[test]
fn every_call_is_right() {
    let lines = lines();
    let wrong: Vec<_> = lines.iter().filter(|line| !is_right(line)).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(lines.len() > 700);
}

/// The first call of each function, with its last word made what no call gives.
#[test]
fn wrong_answers_are_found() {
    let mut functions = HashSet::new();
    for line in lines() {
        if functions.insert(line.split(' ').next().unwrap().to_owned()) {
            let spoilt = format!("{} 7.5", line.rsplit_once(' ').unwrap().0);
            assert!(!is_right(&spoilt), "{spoilt}");
        }
    }
    assert!(functions.len() >= 70);
}
