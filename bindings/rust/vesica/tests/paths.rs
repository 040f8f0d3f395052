// SPDX-License-Identifier: Apache-2.0
//! Polygons and polylines: one, arrays of them in every layout, and what is refused.
use vesica::*;

type Vertex = [f64; 2];

const FRAME: [Vertex; 8] =
    [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0], [2.0, 2.0], [6.0, 2.0], [6.0, 6.0], [2.0, 6.0]];
const TRIANGLE: [Vertex; 3] = [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]];
const BOX: Aabb<f64> = Aabb { min_x: 0.0, min_y: 0.0, max_x: 2.0, max_y: 9.0 };

/// A square of side 8 with a hole of side 4 in its middle.
fn frame() -> Polygon<'static, f64> {
    Polygon::with_rings(&FRAME, &[0, 4, 8]).unwrap()
}

fn triangle() -> Polygon<'static, f64> {
    Polygon::new(&TRIANGLE).unwrap()
}

fn point(x: f64, y: f64) -> Point<f64> {
    Point { x, y }
}

fn disc(cx: f64, cy: f64, r: f64) -> Circle<f64> {
    Circle { cx, cy, r }
}

/// Squares of side 2, 3 apart.
fn squares<const N: usize>() -> [[Vertex; 4]; N] {
    core::array::from_fn(|i| {
        let x = 3.0 * i as f64;
        [[x, 0.0], [x + 2.0, 0.0], [x + 2.0, 2.0], [x, 2.0]]
    })
}

#[test]
fn one_polygon() {
    let (frame, triangle, centre) = (frame(), triangle(), disc(4.0, 4.0, 1.0));
    let ends = [[-1.0, 1.0], [9.0, 1.0], [9.0, 9.0]];
    let chain = Polyline::new(&ends).unwrap();
    assert_eq!(overlap(&frame, &centre), Ok(false));
    assert_eq!(overlap(&frame, &chain), Ok(true));
    assert_eq!(interiors_overlap(&frame, &disc(4.0, 4.0, 2.0)), Ok(false));
    assert_eq!(relation(&triangle, &point(1.0, 1.0)), Ok(Relation::Contains));
    assert_eq!(contains(&frame, &disc(1.0, 1.0, 1.0)), Ok(true));
    assert_eq!(nearest(&frame, &centre).unwrap().distance, 1.0);
    assert_eq!(boundary_distance(&triangle, &disc(1.0, 1.0, 0.5)).unwrap().distance, 0.5);
    assert_eq!(depth(&triangle, &point(1.0, 1.0)).unwrap().depth, 1.0);
    assert_eq!(signed_distance(&triangle, &point(-3.0, 0.0)), Ok(3.0));
    assert_eq!(within(&triangle, &point(-3.0, 0.0), 3.0), Ok(Within::Yes));
    assert_eq!(area(&triangle, &BOX), Ok(4.5));
    assert_eq!(iou(&frame, &Aabb { max_x: 8.0, max_y: 8.0, ..BOX }), Ok(0.75));
    assert_eq!(ratio(Ratio::OverFirst, &triangle, &BOX), Ok(0.75));
    let (across, mut pieces) = (Segment { x0: -1.0, y0: 4.0, x1: 9.0, y1: 4.0 }, [[0.0; 2]; 4]);
    assert_eq!(intersection_into(&frame, &across, &mut pieces), Ok(4));
    assert_eq!(pieces, [[0.0, 4.0], [2.0, 4.0], [6.0, 4.0], [8.0, 4.0]]);
    assert_eq!(intersection_into(&frame, &across, &mut pieces[..2]), Err(Error::Room { needed: 4, given: 2 }));
    assert_eq!(intersection(&triangle, &BOX).unwrap().vertices().len(), 4);
    assert_eq!(shape_area(&frame), Ok(48.0));
    assert_eq!(bounds(&triangle), Ok(Aabb { min_x: 0.0, min_y: 0.0, max_x: 4.0, max_y: 3.0 }));
    assert_eq!(check(&frame), Ok(()));
    let narrow: Vec<[f32; 2]> = FRAME.iter().map(|&[x, y]| [x as f32, y as f32]).collect();
    let narrow = Polygon::with_rings(&narrow, &[0, 4, 8]).unwrap();
    assert_eq!(overlap(&narrow, &Circle { cx: 4.0, cy: 4.0, r: 1.0 }), Ok(false));
    assert_eq!(shape_area(&narrow), Ok(48f32));
}

#[test]
fn arrays() {
    let (squares, discs) = (squares::<3>(), [disc(1.0, 1.0, 1.0), disc(4.0, 1.0, 1.0), disc(9.0, 9.0, 1.0)]);
    let vertices: Vec<Vertex> = squares.iter().flatten().copied().collect();
    let quads = Shapes::even_paths(Kind::Polygon, &squares).unwrap();
    let ringed = Shapes::paths(Kind::Polygon, &vertices, &[0, 4, 8, 12]).unwrap();
    let nested = Shapes::nested_paths(Kind::Polygon, &vertices, &[0, 4, 8, 12], &[0, 1, 3]).unwrap();
    let structs = [Polygon::with_rings(&vertices, &[4, 8]).unwrap(), Polygon::new(&vertices[8..]).unwrap(), frame()];
    assert_eq!([quads.len(), ringed.len(), nested.len()], [3, 3, 2]);
    let mut hits = [false; 9];
    assert_eq!(overlap_many(quads, &discs, &mut hits), Ok(2));
    assert_eq!(overlap_matrix(&structs, &discs, &mut hits), Ok(3));
    assert_eq!(hits, [false, true, false, false, false, false, true, true, false]);
    let mut relations = [Relation::Disjoint; 3];
    assert_eq!(relation_many(quads, ringed, &mut relations), Ok(3));
    assert_eq!(relations, [Relation::Equal; 3]);
    let mut areas = [0.0; 6];
    assert_eq!(area_matrix(nested, quads, &mut areas), Ok(3));
    assert_eq!(areas, [4.0, 0.0, 0.0, 0.0, 4.0, 4.0]);
    let mut boxes = [Aabb::default(); 2];
    bounds_many(nested, &mut boxes).unwrap();
    assert_eq!(boxes[1], Aabb { min_x: 3.0, min_y: 0.0, max_x: 8.0, max_y: 2.0 });
    let mut distance = [0.0; 3];
    let roof = [[0.0, 5.0], [9.0, 5.0]];
    let columns = ClosestPointsColumns { distance: &mut distance, ..Default::default() };
    assert_eq!(nearest_many(quads, &Polyline::new(&roof).unwrap(), columns), Ok(0));
    assert_eq!(distance, [3.0; 3]);
    let mut chosen = [7; 4];
    let over_two = [[1.0, 1.0], [4.0, 1.0], [4.0, 1.5]];
    assert_eq!(overlap_select(&Polygon::new(&over_two).unwrap(), quads, &mut chosen), Ok(2));
    assert_eq!(chosen, [0, 1, -1, 7]);
    let west = Motion { vx: -1.0, vy: 0.0, t_end: 99.0 };
    assert_eq!(cast_first(&point(9.5, 1.0), quads, west).unwrap().map(|(item, _)| item), Some(2));
}

#[test]
fn an_index() {
    let (squares, discs) = (squares::<3>(), [disc(1.0, 1.0, 1.0), disc(4.0, 1.0, 1.0), disc(9.0, 9.0, 1.0)]);
    let quads = Shapes::even_paths(Kind::Polygon, &squares).unwrap();
    let zones = [frame()];
    let index = Index::new(&[quads, discs[..].into(), zones[..].into()]).unwrap();
    let other = Index::new(&[quads]).unwrap();
    assert_eq!(index.join(&other, JoinQuery::Overlap).unwrap().len(), 3 + 2 + 3);
    let mut items = index.select(&frame()).unwrap();
    items.sort_unstable();
    assert_eq!(items, [0, 1, 2, 3, 4, 6]);
    let far = [[20.0, 1.0], [30.0, 1.0]];
    let nearest = index.nearest(&Polyline::new(&far).unwrap(), 1, f64::INFINITY).unwrap();
    assert_eq!(nearest, [(2, 12.0)]);
}

/// What lies beside the library's structs is not read, and vertices are not copied.
#[test]
fn one_of_many_rings() {
    let rings = [0, 4, 8];
    let hole = Polygon::with_rings(&FRAME, &rings[1..]).unwrap();
    assert_eq!(shape_area(&hole), Ok(16.0));
    assert_eq!(core::mem::size_of::<Polygon<'_, f64>>(), core::mem::size_of::<sys::Polygon<f64>>());
}

#[test]
fn what_is_refused() {
    let none: [Vertex; 0] = [];
    assert_eq!(Polygon::new(&none).unwrap_err(), Error::Rings);
    for rings in [&[0, 4][..], &[0, 2, 1], &[-1, 3], &[]] {
        assert_eq!(Polygon::with_rings(&TRIANGLE, rings).unwrap_err(), Error::Rings);
        assert_eq!(Polyline::with_rings(&TRIANGLE, rings).unwrap_err(), Error::Rings);
        assert_eq!(Shapes::paths(Kind::Polygon, &TRIANGLE, rings).unwrap_err(), Error::Rings);
        assert_eq!(Shapes::nested_paths(Kind::Polygon, &TRIANGLE, &[0, 1, 2, 3], rings).unwrap_err(), Error::Rings);
    }
    assert_eq!(Shapes::paths(Kind::Polygon, &none, &[0, 0]).unwrap_err(), Error::Rings);
    assert_eq!(Shapes::even_paths(Kind::Rect, &[TRIANGLE]).unwrap_err(), Error::Kind);
    assert_eq!(Shapes::paths(Kind::Circle, &TRIANGLE, &[0, 3]).unwrap_err(), Error::Kind);
    assert_eq!(Shapes::<f64>::even_paths::<0>(Kind::Polygon, &[[]]).unwrap_err(), Error::Rings);
    assert_eq!(Shapes::packed(Kind::Polygon, &[0.0; 6]).unwrap_err(), Error::Kind);
    assert_eq!(Shapes::<f64>::columns(Kind::Polyline, &[]).unwrap_err(), Error::Kind);
    assert_eq!(AnyShape::<f64>::new(Kind::Polygon, &[]).unwrap_err(), Error::Kind);
    assert_eq!(depth(&frame(), &point(1.0, 1.0)), Err(Error::NotConvex));
    let crossed = [[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]];
    assert_eq!(check(&Polygon::new(&crossed).unwrap()), Err(Error::NotSimple));
    let mut squares = squares::<3>();
    squares[1][2][0] = f64::NAN;
    let quads = Shapes::even_paths(Kind::Polygon, &squares).unwrap();
    let mut hits = [true; 3];
    assert_eq!(overlap_many(quads, &point(1.0, 1.0), &mut hits), Err(Error::Shape));
    assert_eq!(hits, [true, false, false]);
}

#[test]
fn nothing_at_all() {
    let none: [Vertex; 0] = [];
    let paths = Shapes::nested_paths(Kind::Polygon, &none, &[0], &[0]).unwrap();
    assert_eq!(overlap_many(paths, &[frame()][..0], &mut []), Ok(0));
    let index = Index::new(&[paths]).unwrap();
    assert_eq!(index.join(&index, JoinQuery::Overlap).unwrap(), []);
}
