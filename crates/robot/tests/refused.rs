//! What is refused, and that the words name what is wrong.
#![allow(clippy::unwrap_used)]

mod common;

use soilctl_robot::{RobotError, Urdf};

fn robot(inside: &str) -> String {
    format!("<robot name=\"r\">\n{inside}\n</robot>")
}

fn links(names: &[&str]) -> String {
    names.iter().map(|name| format!("<link name=\"{name}\"/>")).collect()
}

fn joint(name: &str, kind: &str, [parent, child]: [&str; 2], more: &str) -> String {
    format!(
        "<joint name=\"{name}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/>{more}</joint>"
    )
}

/// The error of a document, which must name all of these.
#[track_caller]
fn refused(text: &str, named: &[&str]) -> RobotError {
    words(Urdf::parse(text).unwrap_err(), named)
}

/// The error of asking for a link of a document that is sound otherwise.
#[track_caller]
fn asked(inside: &str, link: &str, named: &[&str]) -> RobotError {
    words(Urdf::parse(&robot(inside)).unwrap().chain(link).unwrap_err(), named)
}

#[track_caller]
fn words(error: RobotError, named: &[&str]) -> RobotError {
    let text = error.to_string();
    for name in named {
        assert!(text.contains(name), "{text:?} does not name {name:?}");
    }
    assert!(text.len() < 700 && !text.ends_with('.'), "{text}");
    error
}

#[test]
fn documents_that_are_no_urdf() {
    for text in ["", "  \n", "<!-- only -->"] {
        assert!(matches!(refused(text, &["robot"]), RobotError::NotRobot { .. }));
    }
    refused("<sdf version=\"1.9\"/>", &["sdf", "robot"]);
    let xml = |text: &str, named: &[&str]| {
        assert!(matches!(refused(text, named), RobotError::Xml { .. }), "{text}");
    };
    xml("not xml", &["line 1", "text"]);
    xml("<robot>\n<link name=\"a\"/>\n", &["line 3", "complete"]);
    xml("<robot>\n<link name=\"a\"></joint></robot>", &["line 2", "link"]);
    xml("<robot><link name=\"a\" name=\"b\"/></robot>", &["name", "twice"]);
    xml("<robot><link name=\"a\"/></robot><robot/>", &["second"]);
    xml("<robot><link name=\"a\"/></robot> and more", &["text"]);
    xml("<robot><link name=a/></robot>", &["line 1"]);
    xml("<robot><link name=\"&unknown;\"/></robot>", &["unknown"]);
    xml("<robot><link name=\"a\"/>&unknown;</robot>", &["&unknown;", "write it out"]);
    xml("<robot><link name=\"a\"/>&#0;</robot>", &["&#0;"]);
}

#[test]
fn xacro_that_has_not_been_run() {
    let sources = [
        "<xacro:arg name=\"a\" default=\"1\"/>",
        "<link name=\"${prefix}a\"/>",
        "<link name=\"a\"><inertial><mass value=\"${m}\"/></inertial></link>",
        "<link name=\"a\"><visual><geometry><mesh filename=\"$(find r)/a.stl\"/></geometry></visual></link>",
        "<gazebo><a><xacro:if value=\"1\"/></a></gazebo>",
    ];
    for source in sources {
        let error = refused(&robot(source), &["line 2", "run xacro first"]);
        assert!(matches!(error, RobotError::Xacro { .. }), "{source}");
    }
    // What xacro leaves behind.
    let made = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><link name=\"a\"/></robot>";
    assert!(Urdf::parse(made).is_ok());
}

#[test]
fn trees_that_are_none() {
    assert_eq!(refused(&robot(""), &["no links"]), RobotError::NoLinks);
    refused(&robot(&links(&["a", "b", "a"])), &["two links", "\"a\""]);
    let ab = joint("ab", "fixed", ["a", "b"], "");
    refused(&robot(&format!("{}{ab}{ab}", links(&["a", "b"]))), &["two joints", "\"ab\""]);
    refused(&robot(&format!("{}{ab}", links(&["a"]))), &["\"ab\"", "child", "\"b\""]);
    refused(&robot(&format!("{}{ab}", links(&["b"]))), &["\"ab\"", "parent", "\"a\""]);
    let cb = joint("cb", "fixed", ["c", "b"], "");
    refused(&robot(&format!("{}{ab}{cb}", links(&["a", "b", "c"]))), &["\"b\"", "\"ab\"", "\"cb\""]);
    refused(&robot(&format!("{}{ab}", links(&["c", "a", "b", "d"]))), &["3 links", "c, a, d"]);

    // A ring by itself, beside a root, and with something that hangs on it.
    let [bc, ca] = [joint("bc", "fixed", ["b", "c"], ""), joint("ca", "fixed", ["c", "a"], "")];
    let ring = [ab, bc, ca].concat();
    let tail = joint("cd", "fixed", ["c", "d"], "");
    for (names, tail) in
        [(&["a", "b", "c"][..], ""), (&["root", "a", "b", "c"], ""), (&["d", "a", "b", "c"], &tail)]
    {
        let error = refused(&robot(&format!("{}{tail}{ring}", links(names))), &["ring"]).to_string();
        let rings = ["links a, b, c hang", "links b, c, a hang", "links c, a, b hang"];
        assert!(rings.iter().any(|ring| error.contains(ring)), "{error}");
    }
    let itself = joint("aa", "fixed", ["a", "a"], "");
    refused(&robot(&format!("{}{itself}", links(&["a"]))), &["links a hang", "ring"]);
}

#[test]
fn parts_that_are_missing() {
    refused(&robot("<link/>"), &["line 2", "a link", "name"]);
    refused(&robot("\n<link name=\"\"/>"), &["line 3", "a link", "name"]);
    refused(&robot("<joint type=\"fixed\"/>"), &["a joint", "name"]);
    let two = links(&["a", "b"]);
    refused(&robot(&format!("{two}<joint name=\"j\"/>")), &["\"j\"", "type"]);
    refused(
        &robot(&format!("{two}<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/></joint>")),
        &["\"j\"", "child"],
    );
    refused(
        &robot(&format!("{two}<joint name=\"j\" type=\"fixed\"><parent/></joint>")),
        &["\"j\"", "parent"],
    );
    refused(
        &robot(&format!("{two}{}", joint("j", "ball", ["a", "b"], ""))),
        &["\"j\"", "\"ball\"", "revolute"],
    );
    let mimic = joint("j", "revolute", ["a", "b"], "<mimic multiplier=\"2\"/>");
    refused(&robot(&format!("{two}{mimic}")), &["mimic", "\"j\"", "joint"]);
}

#[test]
fn numbers_that_poses_cannot_be_made_of() {
    let two = links(&["a", "b"]);
    let with = |more: &str| robot(&format!("{two}{}", joint("elbow", "revolute", ["a", "b"], more)));
    for bad in ["inf 0 0", "0 nan 0", "0 0", "0 0 0 0", "a b c", "", "1e10 0 0", "1e999 0 0"] {
        let named = ["\"elbow\"", "three numbers", bad];
        refused(&with(&format!("<origin xyz=\"{bad}\"/>")), &named);
        refused(&with(&format!("<origin rpy=\"{bad}\"/>")), &named);
    }
    for bad in ["0 0 0", "nan 0 1", "0 inf 0", "1 2", "x", "-0 0 0e5"] {
        for kind in ["revolute", "continuous", "prismatic"] {
            let text = robot(&format!(
                "{two}{}",
                joint("elbow", kind, ["a", "b"], &format!("<axis xyz=\"{bad}\"/>"))
            ));
            assert!(matches!(refused(&text, &["\"elbow\"", bad]), RobotError::Axis { .. }));
        }
    }
    for bad in ["multiplier=\"inf\"", "offset=\"nan\"", "offset=\"1 2\""] {
        refused(&with(&format!("<mimic joint=\"elbow\" {bad}/>")), &["mimic", "\"elbow\"", "one number"]);
    }
    let visual = "<link name=\"arm\"><visual><origin xyz=\"0 inf 0\"/><geometry><sphere radius=\"1\"/></geometry></visual></link>";
    refused(&robot(visual), &["visual", "\"arm\"", "0 inf 0"]);
}

#[test]
fn joints_without_one_position_on_the_way_to_a_link() {
    for kind in ["floating", "planar"] {
        let inside = format!(
            "{}{}{}{}",
            links(&["a", "b", "c", "d"]),
            joint("ab", kind, ["a", "b"], "<axis xyz=\"0 0 0\"/>"),
            joint("bc", "revolute", ["b", "c"], ""),
            joint("ad", "revolute", ["a", "d"], "")
        );
        assert!(matches!(asked(&inside, "c", &["\"c\"", "\"ab\"", kind]), RobotError::Free { .. }));
        let urdf = Urdf::parse(&robot(&inside)).unwrap();
        assert_eq!(urdf.chain("d").unwrap().joint_names(), ["ad"]);
        assert_eq!(urdf.end_link("x"), "c");
        let there: Vec<bool> = urdf.link_poses(&|_| None).iter().map(Option::is_some).collect();
        assert_eq!(there, [true, false, false, true]);
    }
    asked(&links(&["a"]), "z", &["\"z\"", "a"]);
}

#[test]
fn mimics_that_cannot_be_followed() {
    let inside = |mimics: [&str; 3]| {
        let [ab, bc, ad] = mimics.map(|other| match other {
            "" => String::new(),
            other => format!("<mimic joint=\"{other}\"/>"),
        });
        [
            links(&["a", "b", "c", "d", "e"]),
            joint("ab", "revolute", ["a", "b"], &ab),
            joint("bc", "prismatic", ["b", "c"], &bc),
            joint("ad", "revolute", ["a", "d"], &ad),
            joint("ae", "fixed", ["a", "e"], ""),
        ]
        .concat()
    };
    let fine = |mimics| Urdf::parse(&robot(&inside(mimics))).unwrap().chain("d").unwrap();
    let missing = inside(["ghost", "", ""]);
    assert!(matches!(
        asked(&missing, "c", &["\"c\"", "\"ab\"", "\"ghost\""]),
        RobotError::MimicMissing { .. }
    ));
    assert_eq!(fine(["ghost", "", ""]).joint_names(), ["ad"]);
    // By way of another.
    asked(&inside(["ad", "", "ghost"]), "c", &["\"ad\"", "\"ghost\""]);

    assert!(matches!(asked(&inside(["ab", "", ""]), "b", &["ring: ab"]), RobotError::MimicRing { .. }));
    let ring = inside(["bc", "ad", "ab"]);
    for link in ["b", "c", "d"] {
        let error = asked(&ring, link, &["ring"]).to_string();
        assert!(
            ["ab, bc, ad", "bc, ad, ab", "ad, ab, bc"].iter().any(|names| error.contains(names)),
            "{error}"
        );
    }
    // One that follows a ring is not part of it.
    asked(&inside(["bc", "bc", ""]), "b", &["ring: bc;"]);

    let still = inside(["ae", "", ""]);
    assert!(matches!(asked(&still, "b", &["\"ab\"", "fixed", "\"ae\""]), RobotError::MimicStill { .. }));
    assert_eq!(fine(["ae", "", ""]).joint_names(), ["ad"]);
    let urdf = Urdf::parse(&robot(&still)).unwrap();
    assert_eq!(urdf.link_poses(&|_| None).iter().filter(|pose| pose.is_some()).count(), 3);
}

#[test]
fn factors_that_grow_without_bound() {
    let mut text = String::from("<robot name=\"r\"><link name=\"l0\"/>");
    for child in 1..=100 {
        let mimic = format!("<mimic joint=\"j{}\" multiplier=\"1000\"/>", child - 1);
        text += &format!("<link name=\"l{child}\"/>");
        let [parent, link] = [format!("l{}", child - 1), format!("l{child}")];
        let more = if child > 1 { &mimic } else { "" };
        text += &joint(&format!("j{child}"), "revolute", [&parent, &link], more);
    }
    let urdf = Urdf::parse(&(text + "</robot>")).unwrap();
    assert!(urdf.chain("l4").unwrap().pose(&[1e-3]).is_some());
    let error = words(urdf.chain("l100").unwrap_err(), &["\"l100\"", "\"j5\""]);
    assert!(matches!(error, RobotError::MimicSize { .. }));
}

/// A message is for people, whatever names a document has.
#[test]
fn names_of_any_length_are_cut() {
    let long = "n".repeat(1 << 20);
    refused(&robot(&links(&[&long, &long])), &["two links"]);
    refused(&format!("<robot><{long}></robot>"), &["nnn"]);
    refused(&format!("<{long}/>"), &["nnn"]);
    refused(&robot(&joint(&long, "fixed", [&long, &long], &format!("<origin xyz=\"{long}\"/>"))), &["nnn"]);
    let many = common::row(5000, "fixed");
    words(Urdf::parse(&many).unwrap().chain("none").unwrap_err(), &["l0, l1", "4980 more"]);
}
