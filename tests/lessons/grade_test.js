// The page grades as the program does: both are held to grading.txt. Also what the page keeps, in a browser that
// lets it and in one that does not.
//
// Usage: node grade_test.js SOURCE    exits 0 when all is well, 1 with a line for each fault

"use strict";

const fs = require("node:fs");
const path = require("node:path");
const vm = require("node:vm");

const source = path.resolve(process.argv[2]);
const pages = path.join(source, "lessons/book/pages");
const Grade = require(path.join(pages, "grade.js"));
let faults = 0;

const expect = (what, found, wanted) => {
  if (JSON.stringify(found) === JSON.stringify(wanted)) return;
  ++faults;
  console.log(`${what}: found ${JSON.stringify(found)}, expected ${JSON.stringify(wanted)}`);
};

const keyOf = ([value, tolerance, unit, foreseen]) => ({
  value: Number(value), tolerance: Number(tolerance), unit, reply: "",
  mistakes: foreseen.split(",").map((text, i) => ({
    kind: ["above", "below"].includes(text.trim()) ? text.trim() : "value", value: Number(text), reply: `foreseen ${i}`,
  })),
});

const table = fs.readFileSync(path.join(source, "tests/lessons/grading.txt"), "utf8");
let rows = 0;
for (const line of table.split("\n")) {
  if (line === "" || line.startsWith("#")) continue;
  const row = line.split("|").map((part) => part.replace(/^ +| +$/g, ""));
  const { grade, reply } = Grade.grade(keyOf(row), row[4]);
  expect(line, grade === "foreseen" ? reply : grade, row[5]);
  ++rows;
}
expect("rows", rows > 80, true);

const pickKeyOf = ([all, right, foreseen]) => ({
  reply: "", picks: all.split(",").map((text) => text.trim().split("=")).map(([name, kind]) =>
    ({ name, kind: kind ?? "", right: right.split(",").some((one) => one.trim() === name) })),
  mistakes: foreseen.split(",").map((text, i) => {
    const picked = text.trim();
    return { kind: ["missing", "more"].includes(picked) ? picked : "kind", picked, reply: `foreseen ${i}` };
  }),
});
let pickRows = 0;
for (const line of fs.readFileSync(path.join(source, "tests/lessons/picking.txt"), "utf8").split("\n")) {
  if (line === "" || line.startsWith("#")) continue;
  const row = line.split("|").map((part) => part.trim());
  const { grade, reply } = Grade.grade(pickKeyOf(row), row[3]);
  expect(line, grade === "foreseen" ? reply : grade, row[4]);
  ++pickRows;
}
expect("rows of picks", pickRows > 20, true);

const choices = { choices: [{ right: false, reply: "No proof." }, { right: true, reply: "" }, { right: false, reply: "" }] };
expect("a foreseen choice", Grade.grade(choices, "a"), { grade: "foreseen", reply: "No proof." });
expect("the right choice", Grade.grade(choices, "b").grade, "right");
expect("another choice", Grade.grade(choices, "c").grade, "wrong");
expect("no choice", Grade.grade(choices, "").grade, "unclear");

// A page of its own for each storage.
const answersWith = (localStorage) =>
  vm.runInNewContext(fs.readFileSync(path.join(pages, "questions.js"), "utf8") + "; Answers", { localStorage });
const storage = (kept) => ({ getItem: () => kept.text ?? null, setItem: (key, text) => { kept.key = key; kept.text = text; } });
const settledStates = (answers) => {
  answers.put("tree", "one", { mistakes: 0, right: true, passed: false, answer: "4" });
  answers.put("tree", "two", { mistakes: 2, right: true, passed: false, answer: "a" });
  answers.put("tree", "three", { mistakes: 1, right: false, passed: true, answer: "" });
  return answers.summary("tree", 5);
};
const wanted = "Of 5 questions: 1 right at the first try, 1 after a mistake, 1 passed, 2 open.";
const kept = {};
expect("a summary", settledStates(answersWith(storage(kept))), wanted);
expect("the key of the book", kept.key, "lodlab-book");
expect("kept for the next visit", answersWith(storage(kept)).summary("tree", 5), wanted);
expect("an answer comes back", answersWith(storage(kept)).of("tree", "one").answer, "4");
const forgetful = answersWith(storage(kept));
forgetful.forget("tree");
expect("forgotten", [forgetful.summary("tree", 5), answersWith(storage(kept)).summary("tree", 5)], ["", ""]);
for (const text of ["", "null", "7", "[]", "{", '{"tree": 3}', '{"tree": {"one": null}}', '"x"'])
  expect(`with ${text} in the storage`, settledStates(answersWith(storage({ text }))), wanted);
const refuse = () => { throw new Error("no storage"); };
expect("without storage", settledStates(answersWith({ getItem: refuse, setItem: refuse })), wanted);
expect("before the first answer", answersWith(storage({})).summary("tree", 5), "");

process.exit(faults === 0 ? 0 : 1);
