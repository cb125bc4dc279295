//! Plans are what they say: every one that ships, and freshly made ones of structures drawn at random, against plain
//! products of rotations. (What is derived by a plan is proved besides, each time.)

use std::collections::BTreeMap;

use kin_gen::plan::graph::Kind;
use kin_gen::plan::recipe::{Operand, Recipe};
use kin_gen::plan::shape::{Direction, Group, Link, Shape};
use kin_gen::plan::{self, WANTED, Wanted, shipped};
use tests::measured;
use tests::sample::Sampler;

type V3 = [f64; 3];
type M3 = [[f64; 3]; 3];

fn product(a: &M3, b: &M3) -> M3 {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

fn column(m: &M3, j: usize) -> V3 {
    [m[0][j], m[1][j], m[2][j]]
}

fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn about_z(angle: f64) -> M3 {
    let (s, c) = angle.sin_cos();
    [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]
}

const RX90: M3 = [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];

/// Numbers for the leaves of a shape.
struct Numbers {
    angles: Vec<f64>,
    links: Vec<[f64; 2]>,
    offsets: Vec<f64>,
}

impl Numbers {
    fn draw(shape: &Shape, random: &mut Sampler) -> Numbers {
        let mut length = |is: bool| if is { random.between(-2.0, 2.0) } else { 0.0 };
        let links = shape.groups.iter().flat_map(|g| g.links.clone());
        let links = links.map(|link| [length(link.x), length(link.y)]).collect();
        let offsets = shape.groups.iter().map(|g| length(g.d)).collect();
        let angles = shape.joints().map(|_| random.between(-3.0, 3.0)).collect();
        Numbers { angles, links, offsets }
    }

    fn leaves(&self) -> BTreeMap<String, f64> {
        let mut leaves = BTreeMap::from([("0".to_owned(), 0.0), ("1".to_owned(), 1.0)]);
        for (index, (angle, [x, y])) in self.angles.iter().zip(&self.links).enumerate() {
            let (s, c) = angle.sin_cos();
            for (letter, value) in [("c", c), ("s", s), ("x", *x), ("y", *y)] {
                leaves.insert(format!("{letter}{}", index + 1), value);
            }
        }
        for (index, d) in self.offsets.iter().enumerate() {
            leaves.insert(format!("d{}", index + 1), *d);
        }
        leaves
    }

    /// What the outputs should be: frame by frame.
    fn expected(&self, shape: &Shape, wanted: Wanted) -> Vec<f64> {
        let (mut frame, mut position) = (about_z(0.0), [0.0; 3]);
        // For each joint the axis, a point on it, and the frame that turns with it.
        let mut joints: Vec<(V3, V3, M3)> = Vec::new();
        let (mut numbers, mut axes) = (self.angles.iter().zip(&self.links), Vec::new());
        let along =
            |at: &mut V3, direction: V3, length: f64| (0..3).for_each(|i| at[i] += length * direction[i]);
        for (index, group) in shape.groups.iter().enumerate() {
            let base = if index == 0 { frame } else { product(&frame, &RX90) };
            let axis = column(&base, 2);
            axes.push(axis);
            along(&mut position, axis, self.offsets[index]);
            for _ in &group.links {
                let Some((angle, link)) = numbers.next() else { unreachable!("as many as there are joints") };
                frame = product(&base, &about_z(*angle));
                joints.push((axis, position, frame));
                along(&mut position, column(&frame, 0), link[0]);
                along(&mut position, column(&frame, 1), link[1]);
            }
        }
        let mut expected = Vec::new();
        if wanted != Wanted::Jacobian {
            expected.extend(frame.iter().flatten().chain(&position));
        }
        if wanted != Wanted::Pose {
            for (axis, point, _) in &joints {
                let reach = [0, 1, 2].map(|i| position[i] - point[i]);
                expected.extend(cross(*axis, reach).iter().chain(axis));
            }
            let number = |at: (usize, usize)| shape.joints().position(|j| j == at).unwrap_or_default();
            for slide in &shape.slides {
                expected.extend(match *slide {
                    Direction::Axis(group) => axes[group],
                    Direction::X(group, joint) => column(&joints[number((group, joint))].2, 0),
                    Direction::Y(group, joint) => column(&joints[number((group, joint))].2, 1),
                });
            }
        }
        expected
    }
}

fn carried_out(recipe: &Recipe<'_>, numbers: &Numbers) -> Vec<f64> {
    let mut values = numbers.leaves();
    for line in &recipe.lines {
        let [a, b] = line.operands.map(|name| values[name]);
        let value = match line.kind {
            Kind::Mul => a * b,
            Kind::Add => a + b,
            Kind::Sub => a - b,
        };
        let before = values.insert(line.name.to_owned(), if line.negative { -value } else { value });
        assert!(before.is_none(), "{} twice", line.name);
    }
    let output =
        |Operand { name, negative }: &Operand<'_>| values[*name] * if *negative { -1.0 } else { 1.0 };
    recipe.outputs.iter().map(output).collect()
}

fn check(wanted: Wanted, shape: &Shape, text: &str, random: &mut Sampler) {
    let recipe = Recipe::parse(text).unwrap_or_else(|| panic!("{} {shape}:\n{text}", wanted.word()));
    for _ in 0..3 {
        let numbers = Numbers::draw(shape, random);
        let (is, should) = (carried_out(&recipe, &numbers), numbers.expected(shape, wanted));
        assert_eq!(is.len(), should.len(), "{} {shape}", wanted.word());
        for (index, (is, should)) in is.iter().zip(&should).enumerate() {
            let off = (is - should).abs();
            assert!(off < 1e-12, "{} {shape}, output {index}: {is} for {should}", wanted.word());
        }
    }
}

fn wanted(word: &str) -> Wanted {
    WANTED.into_iter().find(|w| w.word() == word).unwrap_or_else(|| panic!("{word}"))
}

#[test]
fn every_shipped_plan_is_what_it_says() {
    let mut random = Sampler::new(41);
    let mut count = 0;
    for plan in shipped::all() {
        let shape = Shape::parse(plan.shape).unwrap_or_else(|| panic!("{}", plan.shape));
        assert_eq!(shape.to_string(), plan.shape);
        check(wanted(plan.wanted), &shape, plan.text, &mut random);
        count += 1;
    }
    println!("{count} plans");
    assert_eq!(count, tests::structures::all().len(), "cargo run --release -p tests --bin plans");
}

#[test]
fn plans_of_structures_drawn_at_random() {
    let mut random = Sampler::new(2026);
    for _ in 0..12 {
        let mut shape = Shape::default();
        for _ in 0..1 + random.below(3) {
            let link = |random: &mut Sampler| {
                let x = random.below(2) == 0;
                Link { x, y: x && random.below(4) == 0 }
            };
            let links = (0..1 + random.below(2)).map(|_| link(&mut random)).collect();
            shape.groups.push(Group { d: random.below(2) == 0, links });
        }
        shape.slides.push(Direction::Axis(random.below(shape.groups.len())));
        for wanted in WANTED {
            let text = plan::make_with(&shape, wanted, 1, |values| 4 * values as u32);
            let text = text.unwrap_or_else(|| panic!("{} {shape}", wanted.word()));
            check(wanted, &shape, &text, &mut random);
        }
    }
}

/// The search is a function of the structure: what ships is what the command makes, here for what is made quickly.
#[test]
fn plans_made_again_are_those_that_ship() {
    let mut made = 0;
    for plan in shipped::all() {
        let shape = Shape::parse(plan.shape).unwrap_or_else(|| panic!("{}", plan.shape));
        if shape.joints().count() <= 3 && wanted(plan.wanted) == Wanted::Pose {
            let again = plan::make(&shape, Wanted::Pose).unwrap_or_default();
            assert_eq!(again, plan.text, "{}", plan.shape);
            made += 1;
        }
    }
    assert!(made > 10, "{made}");
}

/// A structure without a plan of its own takes that of the smallest one with more lengths.
#[test]
fn a_structure_that_is_not_there_takes_a_larger_one() {
    let shape = Shape::parse(". xx. dx .").unwrap_or_default();
    assert!(shipped::find(Wanted::Both, &shape).is_none(), "no arm is like that");
    let shape = Shape::parse(". .x d. . d.").unwrap_or_default();
    let (plan, own) = shipped::find(Wanted::Both, &shape).unwrap_or_else(|| panic!("{shape}"));
    assert!(!own);
    assert_eq!(plan.shape, "d. xx d. . d.");
}

/// Common arms of seven joints, as their makers print them, need no style: iiwa, Panda (and xArm7 like it), Sawyer, Gen3.
#[test]
fn common_arms_of_seven_joints_have_plans() {
    let iiwa = "struct Iiwa(standard, m, deg);
        | joint | theta | d    | a | alpha |
        | J1    | q     | 0.34 | 0 | -90   |
        | J2    | q     | 0    | 0 | 90    |
        | J3    | q     | 0.4  | 0 | 90    |
        | J4    | q     | 0    | 0 | -90   |
        | J5    | q     | 0.4  | 0 | -90   |
        | J6    | q     | 0    | 0 | 90    |
        | J7    | q     | 0.126 | 0 | 0    |";
    let xarm = "struct XArm7(modified, m, deg);
        | joint | alpha | a      | d      | theta |
        | J1    | 0     | 0      | 0.267  | q     |
        | J2    | -90   | 0      | 0      | q     |
        | J3    | 90    | 0      | 0.293  | q     |
        | J4    | 90    | 0.0525 | 0      | q     |
        | J5    | 90    | 0.0775 | 0.3425 | q     |
        | J6    | 90    | 0      | 0      | q     |
        | J7    | -90   | 0.076  | 0.097  | q     |";
    let gen3 = "struct Gen3(standard, m, deg);
        | joint | theta   | d       | a | alpha |
        | J1    | q       | -0.2848 | 0 | 90    |
        | J2    | q + 180 | -0.0118 | 0 | 90    |
        | J3    | q + 180 | -0.4208 | 0 | 90    |
        | J4    | q + 180 | -0.0128 | 0 | 90    |
        | J5    | q + 180 | -0.3143 | 0 | 90    |
        | J6    | q + 180 | 0       | 0 | 90    |
        | J7    | q + 180 | -0.1674 | 0 | 0     |";
    let reference = tests::reference::arms().into_iter().filter(|arm| arm.dof == 7);
    let reference: Vec<String> = reference.map(|arm| tests::dh::text(&arm)).collect();
    assert!(reference.len() > 4, "iiwa, Panda and Sawyer are among them");
    let tables = [iiwa, xarm, gen3].into_iter().map(str::to_owned).chain(reference);
    for table in tables {
        for (wanted, shape) in tests::structures::of_table(&table) {
            let own = shipped::find(wanted, &shape).is_some_and(|(_, own)| own);
            assert!(own, "{} {shape} of\n{table}", wanted.word());
        }
    }
}

/// Arms that differ in convention, signs and the places of their frames have one structure.
#[test]
fn one_structure_in_many_conventions() {
    let standard = "struct A(standard, m, deg);
        | joint | theta | d   | a    | alpha |
        | J1    | q     | 0.4 | 0.1  | -90   |
        | J2    | q - 90| 0   | 0.7  | 0     |
        | J3    | q     | 0   | 0.1  | -90   |
        | J4    | q     | 0.8 | 0    | 90    |
        | J5    | q     | 0   | 0    | -90   |
        | J6    | q+180 | 0.1 | 0    | 180   |";
    let modified = "struct B(modified, m, deg);
        | joint | alpha | a    | d    | theta  |
        | J1    | 0     | 0    | 0    | q      |
        | J2    | 90    | -0.2 | 0    | q + 90 |
        | J3    | 180   | 0.6  | 0    | q      |
        | J4    | 90    | 0.2  | -0.7 | q      |
        | J5    | -90   | 0    | 0    | q      |
        | J6    | -90   | 0    | 0.2  | q      |
        base: Tz(0.3) Rz(90);";
    let shapes = [standard, modified].map(|table| {
        let shapes = tests::structures::of_table(table);
        shapes.iter().map(|(wanted, shape)| format!("{} {shape}", wanted.word())).collect::<Vec<_>>()
    });
    assert_eq!(shapes[0], shapes[1]);
    assert_eq!(shapes[0][0], "pose dx xx d. . d.");
    let cost = measured::derived(standard).forward.fk_jacobian.cost();
    println!("{cost}");
}
