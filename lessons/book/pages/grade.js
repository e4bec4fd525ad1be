// Grades an answer as lodlab's own lessons do (lessons/engine/grade.cpp); a test holds both to the same table.
"use strict";

const Grade = (() => {
  const plainSigns = [[/[−–]/g, "-"], [/[\u00a0\u2009\u202f·×≈~=]/g, " "], [/²/g, "2"], [/³/g, "3"]];
  const withPlainSigns = (text) =>
    plainSigns.reduce((plain, [sign, other]) => plain.replace(sign, other), text).trim();
  const plainUnit = (unit) => withPlainSigns(unit).replace(/[ ^*.]/g, "").toLowerCase();

  const degree = Math.PI / 180;
  const sizes = {
    share: { "": 1, "%": 0.01, percent: 0.01 },
    length: { mm: 1e-3, cm: 1e-2, dm: 1e-1, m: 1, metre: 1, metres: 1, meter: 1, meters: 1, km: 1e3 },
    area: { mm2: 1e-6, cm2: 1e-4, m2: 1 },
    time: { ms: 1e-3, s: 1, second: 1, seconds: 1 },
    mass: { g: 1e-3, kg: 1 },
    speed: { "mm/s": 1e-3, "cm/s": 1e-2, "m/s": 1, "km/h": 1 / 3.6 },
    energy: { mj: 1e-3, j: 1, joule: 1, nm: 1, kj: 1e3 },
    impulse: { ns: 1, "kgm/s": 1, "kgcm/s": 1e-2 },
    compliance: { "1/kg": 1, "kg-1": 1, "1/g": 1e3 },
    angle: { rad: 1, "°": degree, deg: degree, degree, degrees: degree },
    spin: { "rad/s": 1, "1/s": 1, "°/s": degree },
    inertia: { kgm2: 1 },
    "angular momentum": { "kgm2/s": 1 },
  };
  const sizeOf = (unit) => {
    for (const [measures, units] of Object.entries(sizes))
      if (Object.hasOwn(units, unit)) return { measures, size: units[unit] };
    return { measures: "", size: 1 };
  };

  const isGrouped = (body, sign) =>
    body.split(sign).every((group, i) => (i === 0 ? group.length >= 1 && group.length <= 3 : group.length === 3));
  const toNumber = (body) => {
    const plain = body.replace(/,/g, ".");
    const value = /^(\d+\.?\d*|\.\d+)(e-?\d+)?$/i.test(plain) ? Number(plain) : NaN;
    const vanished = value === 0 && /[1-9]/.test(plain.split(/e/i)[0]);  // 1e-999
    return Number.isFinite(value) && !vanished ? [value] : [];
  };
  // The readings of digits with points, commas and groups, the likeliest first.
  const readings = (typed) => {
    const body = typed.replace(/[ ']/g, "");
    const point = body.lastIndexOf("."), comma = body.lastIndexOf(",");
    if (point < 0 && comma < 0) return toNumber(body);
    if (point >= 0 && comma >= 0) {
      const [last, group] = point > comma ? [".", ","] : [",", "."];
      const cut = Math.max(point, comma);
      return body.indexOf(last) === cut && isGrouped(body.slice(0, cut), group)
        ? toNumber(body.replaceAll(group, "")) : [];
    }
    const sign = point >= 0 ? "." : ",";
    const values = body.indexOf(sign) === body.lastIndexOf(sign) ? toNumber(body) : [];
    return body[0] !== "0" && isGrouped(body, sign) ? [...values, ...toNumber(body.replaceAll(sign, ""))] : values;
  };
  // One past the digits, points, commas and groups that begin a text. A space belongs to them before exactly three
  // digits.
  const digitsEnd = (text) => {
    let end = 0;
    const digitsFrom = (at) => /^\d*/.exec(text.slice(at))[0].length;
    for (;;) {
      const c = text[end] ?? "";
      if (/\d/.test(c) || (/[.,']/.test(c) && digitsFrom(end + 1) > 0) || (c === "." && end > 0)) ++end;
      else if (c === " " && end > 0 && digitsFrom(end + 1) === 3) end += 4;
      else return end;
    }
  };
  // Takes a number off the front of a text: its readings, and the rest.
  const takeNumber = (text) => {
    const digits = text.slice(0, digitsEnd(text));
    if (digits === "") return { values: [], rest: text };
    const power = /^e([-+]?\d+)/i.exec(text.slice(digits.length));
    const values = power ? toNumber(digits.replaceAll(" ", "") + "e" + power[1].replace("+", "")) : readings(digits);
    return { values, rest: text.slice(digits.length + (power ? power[0].length : 0)) };
  };

  const readNumber = (typed) => {
    const none = { values: [], unit: "" };
    if (new TextEncoder().encode(typed).length > 100) return none;
    let text = withPlainSigns(typed);
    const sign = text.startsWith("-") ? -1 : 1;
    text = text.replace(/^[-+]\s*/, "");
    let { values, rest } = takeNumber(text);
    if (values.length === 0) return none;
    rest = rest.trim();
    if (/^\/[\d ]/.test(rest)) {
      const below = takeNumber(rest.slice(1).trim());
      if (below.values.length === 0 || below.values[0] === 0) return none;
      values = values.map((value) => value / below.values[0]);
      rest = below.rest;
    }
    return { values: values.map((value) => sign * value), unit: plainUnit(rest) };
  };

  const conversion = (unit, typed) => {
    if (typed === "") return { factor: 1 };
    const asked = sizeOf(plainUnit(unit)), given = sizeOf(typed);
    if (asked.measures !== "" && asked.measures === given.measures) return { factor: given.size / asked.size };
    const counts = unit === "" || asked.measures === "";  // "16 tests"
    if (counts && given.measures === "") return { factor: 1 };
    return { unclear: `That unit does not fit. The answer is ${counts ? "a plain number" : `in ${unit}`}.` };
  };

  const isNear = (value, wanted, tolerance) => Math.abs(value - wanted) <= tolerance + 1e-9 * Math.abs(wanted);

  const gradeNumber = (key, answer) => {
    const typed = readNumber(answer);
    if (typed.values.length === 0)
      return { grade: "unclear", reply: `That is no number. Write one as 12, 0.5 or 0,5${key.unit === "" ? "" : `, in ${key.unit} or without`}.` };
    const { factor, unclear } = conversion(key.unit, typed.unit);
    if (unclear) return { grade: "unclear", reply: unclear };
    const values = typed.values.map((value) => factor * value);
    if (values.some((value) => isNear(value, key.value, key.tolerance))) return { grade: "right", reply: key.reply };
    const foreseen =
      key.mistakes.find((m) => m.kind === "value" && values.some((value) => isNear(value, m.value, key.tolerance))) ??
      key.mistakes.find((m) => (m.kind === "above" && values[0] > key.value) || (m.kind === "below" && values[0] < key.value));
    return foreseen ? { grade: "foreseen", reply: foreseen.reply } : { grade: "wrong", reply: "" };
  };

  const gradePicks = (key, answer) => {
    const names = answer.toLowerCase().split(/[\s,;]+/).filter((name) => name !== "" && name !== "and");
    if (!names.every((name) => key.picks.some((pick) => pick.name.toLowerCase() === name)))
      return { grade: "unclear", reply: `Answer with names from the picture: ${key.picks.map((pick) => pick.name).join(", ")}.` };
    const isPicked = (pick) => names.includes(pick.name.toLowerCase());
    const wrong = key.picks.filter((pick) => isPicked(pick) && !pick.right);
    if (wrong.length === 0 && key.picks.every((pick) => isPicked(pick) === pick.right)) return { grade: "right", reply: key.reply };
    const isMade = ({ kind, picked }) => {
      if (kind === "missing") return wrong.length === 0;
      if (kind === "more") return wrong.length > 0;
      return wrong.some((pick) => pick.kind === picked);
    };
    const foreseen = key.mistakes.find(isMade);
    return foreseen ? { grade: "foreseen", reply: foreseen.reply } : { grade: "wrong", reply: "" };
  };

  // What an answer is worth: right; wrong, as foreseen or not; or unclear. The reply may be empty.
  const grade = (key, typed) => {
    const answer = typed.trim();
    if (answer === "")
      return { grade: "unclear", reply: key.picks ? "Pick in the picture, or pass." : key.choices ? "Choose an answer, or pass." : "Type an answer, or pass." };
    if (key.picks) return gradePicks(key, answer);
    if (!key.choices) return gradeNumber(key, answer);
    const choice = key.choices[answer.charCodeAt(0) - 97];
    if (choice.right) return { grade: "right", reply: choice.reply };
    return { grade: choice.reply === "" ? "wrong" : "foreseen", reply: choice.reply };
  };

  return { grade, readNumber, plainUnit };
})();
if (typeof module !== "undefined") module.exports = Grade;
