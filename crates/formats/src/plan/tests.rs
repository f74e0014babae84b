use super::*;

/// A PNG of 8-bit gray.
fn png(rows: &[&str]) -> Vec<u8> {
    let shades: Vec<u8> = rows.iter().flat_map(|row| row.bytes().map(shade)).collect();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, rows[0].len() as u32, rows.len() as u32);
    encoder.set_color(png::ColorType::Grayscale);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&shades).unwrap();
    writer.finish().unwrap();
    bytes
}

fn pgm(rows: &[&str]) -> Vec<u8> {
    let mut bytes = format!("P5\n# a map\n{} {}\n255\n", rows[0].len(), rows.len()).into_bytes();
    bytes.extend(rows.iter().flat_map(|row| row.bytes().map(shade)));
    bytes
}

fn plain_pgm(rows: &[&str]) -> Vec<u8> {
    let shades = rows.iter().flat_map(|row| row.bytes().map(|letter| format!("{}\n", shade(letter))));
    format!("P2 {} {} 255\n{}", rows[0].len(), rows.len(), shades.collect::<String>()).into_bytes()
}

fn shade(letter: u8) -> u8 {
    match letter {
        b'.' => 254,
        b'?' => 205,
        _ => 0,
    }
}

fn trace(picture: &[u8], map: &MapServer) -> Result<Plan, String> {
    Plan::trace(picture, map, "hall", "hall.png").map_err(|error| error.to_string())
}

/// Half a metre a pixel.
fn coarse() -> MapServer {
    MapServer::of_picture("hall.png", 0.5)
}

const HALL: [&str; 9] = [
    "##############",
    "#..........#.#",
    "#..........###",
    "#..........??#",
    "#....##....??#",
    "#....##....??#",
    "#..........??#",
    "#..........??#",
    "##############",
];

#[test]
fn what_is_not_free_becomes_walls_and_the_robot_stands_where_there_is_room() {
    for picture in [png(&HALL), pgm(&HALL), plain_pgm(&HALL)] {
        let map = MapServer { origin: [-1.0, 2.0, 0.0], ..coarse() };
        let plan = trace(&picture, &map).unwrap();
        assert_eq!(plan.size, [7.0, 4.5]);
        assert_eq!((plan.kept, plan.left_out), (66.0 * 0.25, 0.25));
        let walls: Vec<Vec<[f64; 2]>> = vec![
            vec![[4.5, 6.0], [4.5, 2.5], [-0.5, 2.5], [-0.5, 6.0], [4.5, 6.0]],
            vec![[1.5, 4.5], [1.5, 3.5], [2.5, 3.5], [2.5, 4.5], [1.5, 4.5]],
        ];
        let same =
            |a: &[[f64; 2]], b: &[[f64; 2]]| a.len() == b.len() && a.iter().all(|corner| b.contains(corner));
        assert!(plan.world.walls.iter().zip(&walls).all(|(a, b)| same(a, b)), "{:?}", plan.world.walls);
        assert_eq!(plan.pieces, 8);
        assert_eq!(plan.world.problems(), []);
    }
}

#[test]
fn the_same_picture_gives_the_same_world() {
    let plans = [(); 2].map(|()| trace(&png(&HALL), &coarse()).unwrap());
    assert_eq!(plans[0], plans[1]);
    assert_eq!(crate::world::read(&crate::world::write(&plans[0].world), "hall").unwrap(), plans[0].world);
}

#[test]
fn black_is_free_where_the_map_says_so() {
    let dark: Vec<String> = HALL.iter().map(|row| row.replace('.', "_").replace(['#', '?'], ".")).collect();
    let dark: Vec<&str> = dark.iter().map(String::as_str).collect();
    let plan = trace(&png(&dark), &MapServer { negate: true, ..coarse() }).unwrap();
    assert_eq!(plan.kept, 66.0 * 0.25);
}

#[test]
fn a_turned_origin_turns_the_walls() {
    let quarter = cogmap_geometry::trig::FRAC_PI_2;
    let plan = trace(&png(&HALL), &MapServer { origin: [0.0, 0.0, quarter], ..coarse() }).unwrap();
    assert!(plan.world.walls[0].iter().all(|[x, y]| *x < 0.0 && *y > 0.0));
}

#[test]
fn a_picture_without_room_for_a_robot_says_so() {
    for (picture, map) in [
        (png(&["####", "####"]), coarse()),
        (png(&HALL), MapServer::of_picture("hall.png", 0.05)),
        (png(&["?????", "?????", "?????", "?????"]), coarse()),
    ] {
        let error = trace(&picture, &map).unwrap_err();
        assert!(error.starts_with("hall.png: nowhere in its") && error.contains("resolution"), "{error}");
    }
}

#[test]
fn noise_is_refused_before_it_costs_much() {
    let mut state = 1_u32;
    let mut noise = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        if state >> 30 == 0 { '#' } else { '.' }
    };
    let mut rows: Vec<String> = (0..1200).map(|_| (0..1200).map(|_| noise()).collect()).collect();
    for row in &mut rows[..40] {
        *row = ".".repeat(1200);
    }
    let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
    let pieces = trace(&png(&rows), &MapServer::of_picture("hall.png", 0.05)).map(|plan| plan.pieces);
    let error = pieces.unwrap_err();
    assert!(error.contains("straight pieces") && error.contains("clean"), "{error}");
}

#[test]
fn broken_pictures_get_an_answer() {
    let (whole, graymap) = (png(&HALL), pgm(&HALL));
    let mut huge = whole.clone();
    huge[16..24].copy_from_slice(&[0x7f, 0xff, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff]);
    for bytes in [
        &whole[..whole.len() / 2],
        &whole[..20],
        &graymap[..graymap.len() - 3],
        &huge,
        b"P5\n0 0\n255\n",
        b"P5 99999999999 99999999999 255\n",
        b"P5 99999999999999999999999999 1 255\n",
        b"P5 4000000 4000000 255\n",
        b"P2 4000 4000 255\n 1 2 3",
        b"P2 2 2 0\n 1 2 3 4",
        b"P2 2 2 255\n 1 x 3 4",
        b"P5",
        b"P5 # no end",
        b"GIF89a",
        b"",
    ] {
        let error = trace(bytes, &coarse()).unwrap_err();
        assert!(error.starts_with("hall.png: ") && error.contains("; "), "{error}");
    }
}

proptest::proptest! {
    #[test]
    fn whatever_bytes_a_picture_has_there_is_an_answer(
        cut in 0_usize..200, at in 0_usize..200, byte: u8, graymap: bool,
    ) {
        let mut bytes = if graymap { pgm(&HALL) } else { png(&HALL) };
        let (cut, at) = (cut % bytes.len(), at % bytes.len());
        bytes[at] = byte;
        let _ = trace(&bytes[..bytes.len() - cut], &coarse());
    }
}
