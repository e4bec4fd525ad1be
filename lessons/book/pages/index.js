// What became of each lesson's questions, beside the lesson.
"use strict";

for (const line of document.querySelectorAll(".lessons .tally")) showTally(line);
