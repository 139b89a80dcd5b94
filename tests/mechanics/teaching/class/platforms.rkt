#lang racket/base
;; Files for learning platforms, checked by a program that reads them as the platforms document:
;; Moodle's import of grades, and the results of Gradescope.

(require mechanics/teaching/class/class-list
         mechanics/teaching/class/class-tables
         mechanics/teaching/class/grade
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/make-worksheet
         racket/file
         racket/string
         "../../support/checks.rkt" "../../support/class-reports.rkt"
         "../../support/folder.rkt" "../../support/python.rkt" "../../support/skip.rkt")

(define w
  (make-worksheet "Pendel, größer \"=1\"" #f "w"
                  (list (make-exercise 'two 'number "?" '((key 2)))
                        (make-exercise 'why 'reason "?" '((points 3))))))

(define class
  (with-folder (folder)
    (define file (build-path folder "list.csv"))
    (display-to-file
     (string-append "First name,Last name,ID number,Email address\n"
                    "Ann,\"Arbor, Jr.\",0012,Ann@uni.edu\n"
                    "\"=HYPERLINK(\"\"http://x\"\")\",Bell,13,bob@uni.edu\n"
                    "Çelik,Ünal 漢,14,c@uni.edu\n")
     file)
    (read-class-list 'check file)))

(define r
  (report-of w class
             '("Ann@uni.edu" "Ann" (answer 2) (text "=cmd|' /C calc'!A0\r\nand, \"more\""))
             '("bob@uni.edu" "@SUM(1)" (failed "a\u001b[2J, \"b\"") (text "+1"))
             '("Çelik Ünal 漢" "x" (answer 3) (unanswered))
             '("eve" "-2+3" (answer 2) (unanswered))))

;; Moodle (docs.moodle.org, Grade import): UTF-8, the first line names the columns, each once; a
;; column identifies the user; grades are numbers up to the most; feedback comes with its grade.
(define Moodle-rules #<<py
import csv, re
with open("grades.csv", encoding="utf-8", newline="") as file:
    rows = list(csv.reader(file, strict=True))
head, rows = rows[0], rows[1:]
assert len(set(head)) == len(head) and all(head), head
assert head[:2] == ["Email address", "ID number"], head
grade = head.index(head[3].replace(" (feedback)", ""))
assert all(len(row) == len(head) for row in rows), rows
for place in (0, 1):
    ids = [row[place] for row in rows]
    assert all(ids) and len(set(ids)) == len(ids), ids
for row in rows:
    assert re.fullmatch(r"\d+(\.\d+)?", row[grade]) and 0 <= float(row[grade]) <= 4, row
    assert row[3], row
    assert not any(re.match(r"\s*[=+@|%-]", cell) for cell in row), row
    assert not any(re.search(r"[\x00-\x1f\x7f]", cell) for cell in row), row
print([(row[0], row[1], row[2]) for row in rows])
py
  )

;; Gradescope (gradescope-autograders.readthedocs.io, specs): a score, or one for each test; texts;
;; states and visibilities of a few names.
(define Gradescope-rules #<<py
import json, math
def refuse(x): raise ValueError(x)
for name in ("0", "1", "2", "3"):
    with open(name + ".json", encoding="utf-8") as file:
        result = json.load(file, parse_constant=refuse)
    assert isinstance(result["score"], (int, float)) and math.isfinite(result["score"])
    assert isinstance(result["output"], str)
    seen = {"hidden", "after_due_date", "after_published", "visible"}
    assert result["visibility"] in seen
    for test in result["tests"]:
        assert set(test) <= {"name", "score", "max_score", "output", "status", "visibility"}, test
        assert isinstance(test["name"], str) and isinstance(test["output"], str)
        assert 0 <= test["score"] <= test["max_score"]
        assert test.get("status", "passed") in ("passed", "failed")
    assert result["score"] <= sum(test["max_score"] for test in result["tests"])
    print(result["score"])
py
  )

(define python (python-with "csv" "json"))

(skip-unless python "no Python: what Moodle and Gradescope read"
  (test-case "Moodle's import of grades"
    (with-folder (folder)
      (display-to-file (class->Moodle r) (build-path folder "grades.csv"))
      (check-equal? (run-python python folder Moodle-rules)
                    (string-append "[('Ann@uni.edu', '0012', '1'), ('bob@uni.edu', '13', '0'), "
                                   "('c@uni.edu', '14', '0')]\n"))))
  (test-case "Gradescope's results"
    (with-folder (folder)
      (for ([g (class-report-graded r)] [k 4])
        (display-to-file (graded->Gradescope g) (build-path folder (format "~a.json" k))))
      (check-equal? (run-python python folder Gradescope-rules) "1.0\n0.0\n0.0\n1.0\n"))))

(test-case "no cell of the report begins like a formula, in any spelling"
  (define cells (regexp-match* #px"\"((?:[^\"]|\"\")*)\"" (class->csv r) #:match-select cadr))
  (for ([c cells])
    (check-false (regexp-match? #px"^\\s*[=+@\\-|%＝＋＠－]" c) c))
  (check-true (string-contains? (class->csv r) "'=HYPERLINK(\"\"http://x\"\") Bell")))
