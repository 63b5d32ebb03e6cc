//! Documents made to do harm: there is an answer or an error, soon, and nothing panics.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::print_stdout)]

mod common;

use std::time::{Duration, Instant};

use common::row;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use soilctl_robot::{MOST_BYTES, MOST_DEPTH, MOST_LINKS, RobotError, Urdf};

/// Everything that can be asked of a document; its answers must be sound.
fn ask(text: &str) -> Result<(), RobotError> {
    let urdf = Urdf::parse(text).inspect_err(|error| assert!(error.to_string().len() > 10))?;
    let end = urdf.end_link("plate_tip");
    assert!(urdf.link_index(end).is_some());
    assert_eq!(urdf.outwards().len(), urdf.links().len());
    for link in urdf.links().iter().take(20) {
        match urdf.chain(&link.name) {
            Ok(chain) => {
                for position in [0.0, -1.3, 1e300, f64::NAN, f64::INFINITY] {
                    let positions = vec![position; chain.joint_names().len()];
                    let pose = chain.pose(&positions);
                    assert!(pose.is_some() || !position.is_finite() || position > 1e299);
                    assert!(
                        pose.is_none_or(|pose| pose.to_homogeneous().iter().all(|number| number.is_finite()))
                    );
                }
            }
            Err(error) => assert!(error.to_string().len() > 20),
        }
    }
    for position in [None, Some(0.7), Some(f64::MAX), Some(f64::NAN)] {
        let poses = urdf.link_poses(&|_| position);
        assert_eq!(poses.len(), urdf.links().len());
        assert!(
            poses.iter().flatten().all(|pose| pose.to_homogeneous().iter().all(|number| number.is_finite()))
        );
    }
    Ok(())
}

/// A document with something of everything in it.
const SMALL: &str = r#"<?xml version="1.0"?>
<!DOCTYPE robot [<!ENTITY a "b">]>
<robot name="hand" xmlns:xacro="x">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="a"><visual><origin xyz="0 0 0.1" rpy="0 1 0"/><geometry><box size="1 2 3"/></geometry><material name="grey"/></visual></link>
  <link name="b"><inertial><mass value="1"/></inertial><visual><geometry><mesh filename="b.stl"/></geometry></visual></link>
  <link name="c"/><link name="d &amp; e"/>
  <joint name="ab" type="revolute"><parent link="a"/><child link="b"/><origin xyz="1 2 3" rpy="0 0 1"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="1" effort="1" velocity="1"/></joint>
  <joint name="bc" type="prismatic"><parent link="b"/><child link="c"/><mimic joint="ab" multiplier="2" offset="-1"/></joint>
  <joint name="cd" type="fixed"><parent link="c"/><child link="d &amp; e"/></joint>
  <gazebo><![CDATA[x]]></gazebo><!-- ü -->
</robot>
"#;

#[test]
fn a_document_may_end_anywhere() {
    ask(SMALL).unwrap();
    let whole = SMALL.trim_end().len();
    for end in (0..whole).filter(|end| SMALL.is_char_boundary(*end)) {
        assert!(ask(&SMALL[..end]).is_err(), "{end}");
    }
}

/// Bits that flip, parts that go, parts that come twice, words that come from elsewhere.
#[test]
fn a_document_may_be_damaged_in_any_way() {
    const WORDS: [&str; 16] = [
        "nan",
        "inf",
        "-1e308",
        "1e-320",
        "\"",
        "<",
        ">",
        "/>",
        "&",
        "&#x110000;",
        "<!--",
        "]]>",
        "<![CDATA[",
        "<?",
        "</link>",
        "mimic",
    ];
    let mut random = Pcg64Mcg::seed_from_u64(20_260_101);
    let arm = soilctl_kinematics::urdf(&soilctl_kinematics::Arm::thesis());
    let mut sound = 0;
    for round in 0..4000 {
        let mut bytes = if round % 2 == 0 { SMALL } else { &arm }.as_bytes().to_vec();
        let mut below = |limit: usize| (random.next_u64() % (limit as u64 + 1)) as usize;
        for _ in 0..=below(3) {
            let from = below(bytes.len());
            let to = (from + below(40)).min(bytes.len());
            match below(3) {
                0 if from < bytes.len() => bytes[from] ^= 1 << below(7),
                1 => drop(bytes.drain(from..to)),
                2 => {
                    let part = bytes[from..to].to_vec();
                    let place = below(bytes.len());
                    bytes.splice(place..place, part);
                }
                _ => drop(bytes.splice(from..to, WORDS[below(WORDS.len() - 1)].bytes())),
            }
        }
        sound += usize::from(ask(&String::from_utf8_lossy(&bytes)).is_ok());
    }
    // Neither all of them nor none: the damage reaches what comes after the reader of XML.
    assert!((200..3000).contains(&sound), "{sound}");
}

#[test]
fn deep_documents_are_refused() {
    for name in ["a", "link", "robot", "joint"] {
        let deep = format!("<robot>{}", format!("<{name} name=\"x\" type=\"fixed\">").repeat(100_000));
        assert_eq!(Urdf::parse(&deep).unwrap_err(), RobotError::TooDeep { line: 1 });
    }
    let levels = |count: usize| {
        format!("<robot><link name=\"a\"/>{}{}</robot>", "<a>".repeat(count), "</a>".repeat(count))
    };
    assert!(Urdf::parse(&levels(MOST_DEPTH - 1)).is_ok());
    assert!(Urdf::parse(&levels(MOST_DEPTH)).is_err());
}

#[test]
fn a_billion_laughs_are_not_heard() {
    let mut text = String::from("<?xml version=\"1.0\"?><!DOCTYPE robot [<!ENTITY l0 \"ha\">");
    for level in 1..30 {
        let before = level - 1;
        text += &format!("<!ENTITY l{level} \"{}\">", format!("&l{before};").repeat(10));
    }
    text += "]>";
    let refused = |inside: &str| {
        let error = Urdf::parse(&format!("{text}<robot name=\"r\">{inside}</robot>")).unwrap_err();
        assert!(matches!(&error, RobotError::Xml { .. }) && error.to_string().contains("l29"), "{error}");
    };
    refused("<link name=\"a\"/>&l29;");
    refused("<link name=\"&l29;\"/>");
    let urdf = Urdf::parse(&format!("{text}<robot name=\"r\"><link name=\"a\"/></robot>")).unwrap();
    assert!(urdf.notes()[0].contains("document type"));
}

/// Most take well below a second; a machine may do other things as well. Time with the square of the size would be hours.
fn soon<T>(what: &str, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let answer = work();
    let took = start.elapsed();
    println!("{what}: {} ms", took.as_millis());
    assert!(took < Duration::from_secs(30), "{what} took {took:?}");
    answer
}

#[test]
fn long_chains_take_time_in_proportion() {
    for count in [20_000, MOST_LINKS] {
        let text = row(count, "prismatic");
        let last = format!("l{}", count - 1);
        let chain = soon(&format!("{count} links read, checked and a chain made"), || {
            let urdf = Urdf::parse(&text).unwrap();
            assert_eq!(urdf.end_link("tip"), last);
            urdf.chain(&last).unwrap()
        });
        let pose = soon("a pose", || chain.pose(&vec![0.0; count - 1]).unwrap());
        assert_eq!(pose.translation.vector.x, (count - 1) as f64);
        let poses = soon("all poses", || Urdf::parse(&text).unwrap().link_poses(&|_| None));
        assert_eq!(poses[count - 1].unwrap(), pose);
    }
    let more = row(MOST_LINKS + 1, "fixed");
    assert_eq!(Urdf::parse(&more).unwrap_err(), RobotError::TooMany { what: "links" });
}

/// The product of many turns is still a turn.
#[test]
fn long_chains_of_turns_stay_rigid() {
    let chain = Urdf::parse(&row(20_000, "revolute")).unwrap().chain("l19999").unwrap();
    let pose = chain.pose(&vec![0.01; 19_999]).unwrap();
    assert!((pose.rotation.norm() - 1.0).abs() < 1e-10);
    // All of it in a plane: by the sum of the angles.
    let expected = nalgebra::UnitQuaternion::from_axis_angle(&nalgebra::Vector3::z_axis(), 199.99);
    assert!(pose.rotation.angle_to(&expected) < 1e-9);
}

/// A chain in which each joint mimics the next, so that each is resolved by way of all others; and as a ring.
#[test]
fn long_mimics_take_time_in_proportion() {
    let count = 50_000;
    for ring in [false, true] {
        let mut text = String::from("<robot name=\"r\"><link name=\"l0\"/>");
        for joint in 1..count {
            let (before, next) = (joint - 1, joint % (count - 1) + 1);
            let mimic =
                if ring || joint + 1 < count { format!("<mimic joint=\"j{next}\"/>") } else { String::new() };
            text += &format!(
                "<link name=\"l{joint}\"/><joint name=\"j{joint}\" type=\"prismatic\"><parent link=\"l{before}\"/>\
                 <child link=\"l{joint}\"/>{mimic}</joint>"
            );
        }
        text += "</robot>";
        let last = format!("l{}", count - 1);
        let chain = soon("mimics of mimics", || Urdf::parse(&text).unwrap().chain(&last));
        match chain {
            Ok(chain) => {
                assert_eq!(chain.joint_names(), [format!("j{}", count - 1)]);
                assert_eq!(chain.pose(&[0.5]).unwrap().translation.vector.x, 0.5 * (count - 1) as f64);
            }
            Err(error) => assert!(ring && matches!(error, RobotError::MimicRing { .. })),
        }
    }
}

/// As much as is read, of what is smallest and comes most often.
#[test]
fn large_documents_of_little_are_read_or_refused_soon() {
    let filled = |before: &str, part: &str, after: &str| {
        let room = MOST_BYTES - before.len() - after.len();
        [before, &part.repeat(room / part.len()), after].concat()
    };
    let none = || filled("<robot>", "<a/>", "</robot>");
    assert_eq!(soon("elements", || Urdf::parse(&none())).unwrap_err(), RobotError::NoLinks);
    let visuals = filled("<robot><link name=\"a\">", "<visual/>", "</link></robot>");
    assert_eq!(
        soon("visuals", || Urdf::parse(&visuals)).unwrap_err(),
        RobotError::TooMany { what: "visuals" }
    );
    let attributes = filled("<robot><link name=\"a\"", " b=\"\"", "/></robot>");
    assert!(soon("attributes", || Urdf::parse(&attributes)).is_ok());
    let name = filled("<robot><link name=\"", "n", "\"/></robot>");
    assert!(soon("one name", || Urdf::parse(&name)).is_ok());
    let words = filled("<robot><link name=\"a\"/>", "word ", "</robot>");
    assert!(soon("words", || Urdf::parse(&words)).is_ok());
    let long = filled("<robot><link name=\"a\"/>", "word ", "</robot>") + "     ";
    assert!(matches!(Urdf::parse(&long).unwrap_err(), RobotError::TooLong { .. }));
    let open = filled("<robot>", "<", "");
    assert!(soon("signs", || Urdf::parse(&open)).is_err());
}

/// Many links that hang on one, and many rings.
#[test]
fn broad_trees_and_many_rings_take_time_in_proportion() {
    let mut star = String::from("<robot><link name=\"hub\"/>");
    let mut rings = star.clone();
    for leaf in 0..40_000 {
        let other = leaf ^ 1;
        let hung = |parent: &str| {
            format!(
                "<link name=\"l{leaf}\"/><joint name=\"j{leaf}\" type=\"revolute\"><parent link=\"{parent}\"/><child link=\"l{leaf}\"/></joint>"
            )
        };
        star += &hung("hub");
        rings += &hung(&format!("l{other}"));
    }
    let star = soon("a star", || Urdf::parse(&(star + "</robot>"))).unwrap();
    assert_eq!(star.end_link("x"), "l0");
    let error = soon("rings", || Urdf::parse(&(rings + "</robot>"))).unwrap_err();
    assert!(
        matches!(&error, RobotError::Ring { links } if links == "l1, l0" || links == "l0, l1"),
        "{error}"
    );
}
