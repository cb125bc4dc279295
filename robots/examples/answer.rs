//! Answers kinematics requests, so that a scorer in any language can judge the arms of this crate.
//!
//! One JSON object per line comes in on stdin, one per line goes out on stdout, with the same `id`:
//!
//! ```text
//! {"id":1,"arm":"puma560","op":"fk","q":[…]}                      {"id":1,"pose":[[4x4]]}
//! {"id":2,"arm":"puma560","op":"jacobian","q":[…]}                {"id":2,"jacobian":[[6 rows x n]]}
//! {"id":3,"arm":"puma560","op":"ik","pose":[[4x4]],"task":"pose"} {"id":3,"solutions":[[…],…]}
//! ```
//!
//! Lengths are metres whatever the unit of the arm, angles radians, arms have their names in the reference data of the
//! `tests` member. `task` is `pose` or `position`; limits are not applied. What has no answer gets
//! `{"id":…,"error":"…"}`.

use std::io::{self, BufRead, BufWriter, Write};

use kin_runtime::{DynArm, DynOutcome, DynSlot, Inverse, JointKind, Pose};
use serde_json::{Value, json};

const HELP: &str = "answer: reads kinematics requests as JSON lines on stdin, writes answers as JSON lines on stdout

  {\"id\":1,\"arm\":\"puma560\",\"op\":\"fk\",\"q\":[...]}
  {\"id\":2,\"arm\":\"puma560\",\"op\":\"jacobian\",\"q\":[...]}
  {\"id\":3,\"arm\":\"puma560\",\"op\":\"ik\",\"task\":\"pose\",\"pose\":[[...],...]}      (or \"task\":\"position\")

metres and radians; arms:";

macro_rules! arms {
    ($($Arm:ident $file:ident $inverse:ident $reference:tt;)*) => {
        /// The arms that the reference data knows, by the name it gives them.
        const ARMS: &[(&str, &dyn DynArm)] = &[$((name!($Arm $reference), &robots::$Arm)),*];
    };
}

/// An arm that the reference data does not know answers to its own name.
macro_rules! name {
    ($Arm:ident _) => {
        stringify!($Arm)
    };
    ($Arm:ident $reference:literal) => {
        $reference
    };
}

robots::for_each!(arms);

fn main() -> io::Result<()> {
    if std::env::args().len() > 1 {
        println!("{HELP}");
        for (name, arm) in ARMS {
            println!("  {name:<20} {}", arm.name());
        }
        return Ok(());
    }
    let mut out = BufWriter::new(io::stdout().lock());
    for line in io::stdin().lock().split(b'\n') {
        let line = line?;
        if line.iter().all(u8::is_ascii_whitespace) {
            continue;
        }
        serde_json::to_writer(&mut out, &answer(&line))?;
        out.write_all(b"\n")?;
    }
    out.flush()
}

/// The answer to one line, whatever it holds.
fn answer(line: &[u8]) -> Value {
    let request: Value = match serde_json::from_slice(line) {
        Ok(request) => request,
        Err(error) => return json!({ "id": null, "error": format!("not a JSON object: {error}") }),
    };
    match reply(&request) {
        Ok((key, value)) => json!({ "id": request["id"], key: value }),
        Err(error) => json!({ "id": request["id"], "error": error }),
    }
}

/// The key and the value of the answer.
fn reply(request: &Value) -> Result<(&'static str, Value), String> {
    let wanted = request["arm"].as_str().ok_or("`arm` is not a name")?;
    let (_, arm) =
        ARMS.iter().find(|(name, _)| *name == wanted).ok_or_else(|| format!("unknown arm `{wanted}`"))?;
    match request["op"].as_str() {
        Some("fk") => {
            Ok(("pose", matrix(&fk(*arm, &joints(*arm, &request["q"])?)?, arm.length_unit().metres())))
        }
        Some("jacobian") => Ok(("jacobian", jacobian(*arm, &joints(*arm, &request["q"])?)?)),
        Some("ik") => Ok(("solutions", inverse(*arm, request)?)),
        _ => Err("`op` is none of `fk`, `jacobian`, `ik`".into()),
    }
}

/// One for a turning joint, metres in the unit of the arm for a sliding one.
fn unit(arm: &dyn DynArm, joint: usize) -> f64 {
    match arm.joints()[joint].kind {
        JointKind::Revolute => 1.0,
        JointKind::Prismatic => arm.length_unit().metres(),
    }
}

fn joints(arm: &dyn DynArm, q: &Value) -> Result<Vec<f64>, String> {
    let q = numbers(q).ok_or("`q` is not a list of numbers")?;
    if q.len() != arm.joints().len() {
        return Err(format!("`q` has {} values, {} has {} joints", q.len(), arm.name(), arm.joints().len()));
    }
    Ok(q.iter().enumerate().map(|(joint, value)| value / unit(arm, joint)).collect())
}

fn numbers(list: &Value) -> Option<Vec<f64>> {
    list.as_array()?.iter().map(Value::as_f64).collect()
}

fn fk(arm: &dyn DynArm, q: &[f64]) -> Result<Pose<f64>, String> {
    arm.pose_at(q).map_err(|error| error.to_string())
}

/// A pose as a 4×4 matrix, its lengths multiplied by `scale`.
fn matrix(pose: &Pose<f64>, scale: f64) -> Value {
    let (r, p) = (pose.rotation.matrix(), pose.translation.vector);
    let row = |i: usize| json!([r[(i, 0)], r[(i, 1)], r[(i, 2)], p[i] * scale]);
    json!([row(0), row(1), row(2), [0, 0, 0, 1]])
}

fn jacobian(arm: &dyn DynArm, q: &[f64]) -> Result<Value, String> {
    let mut columns = vec![[0.0; 6]; q.len()];
    arm.jacobian_at(q, &mut columns).map_err(|error| error.to_string())?;
    let metres = arm.length_unit().metres();
    let entry = |(c, column): (usize, &[f64; 6]), r: usize| {
        column[r] * if r < 3 { metres } else { 1.0 } / unit(arm, c)
    };
    let row = |r: usize| columns.iter().enumerate().map(|column| entry(column, r)).collect::<Vec<_>>();
    Ok(json!((0..6).map(row).collect::<Vec<_>>()))
}

fn inverse(arm: &dyn DynArm, request: &Value) -> Result<Value, String> {
    let target = pose(&request["pose"], arm.length_unit().metres()).ok_or("`pose` is not a 4x4 matrix")?;
    let oriented = match request["task"].as_str() {
        Some("pose") => true,
        Some("position") => false,
        _ => return Err("`task` is neither `pose` nor `position`".into()),
    };
    if !request["lock"].is_null() {
        return Err("joints cannot be locked".into());
    }
    let mut found: Vec<Vec<f64>> = Vec::new();
    let mut visit = |slot: DynSlot<'_>| {
        if let DynOutcome::Solved { q, .. } = slot.outcome {
            found.push(q.to_vec());
        }
    };
    match (arm.inverse(), oriented) {
        (Inverse::Pose | Inverse::PoseOrPosition, true) => arm.solve_pose(&target, &mut visit),
        (Inverse::Position | Inverse::PoseOrPosition, false) => {
            arm.solve_position(target.translation.vector.into(), &mut visit)
        }
        _ => return Err(format!("{} has no inverse for this task", arm.name())),
    }
    .map_err(|error| error.to_string())?;
    let metres =
        |q: Vec<f64>| q.iter().enumerate().map(|(joint, value)| value * unit(arm, joint)).collect::<Vec<_>>();
    Ok(json!(found.into_iter().map(metres).collect::<Vec<_>>()))
}

/// The pose of a 4×4 matrix in metres, in an arm's own unit; the rotation is taken as it is.
fn pose(value: &Value, metres: f64) -> Option<Pose<f64>> {
    let rows: Vec<Vec<f64>> = value.as_array()?.iter().map(numbers).collect::<Option<_>>()?;
    let [[a, b, c, x], [d, e, f, y], [g, h, i, z]] = rows
        .get(..3)?
        .iter()
        .map(|row| row.as_slice().try_into().ok())
        .collect::<Option<Vec<[f64; 4]>>>()?
        .try_into()
        .ok()?;
    let rotation =
        nalgebra::Rotation3::from_matrix_unchecked(nalgebra::Matrix3::new(a, b, c, d, e, f, g, h, i));
    Some(Pose::from_parts(nalgebra::Translation3::new(x / metres, y / metres, z / metres), rotation))
}
