#lang racket/base
;; Words in lines: a line may be as long as the width, no longer.

(require mechanics/show/display/filled-lines
         "../../support/checks.rkt")

(define words '("a" "bc" "def" "g"))

(test-case "a line ends before the word that would go beyond the width"
  (check-equal? (filled words 11) '("a bc def g"))
  (check-equal? (filled words 10) '("a bc def g"))
  (check-equal? (filled words 9) '("a bc def" "g"))
  (check-equal? (filled words 8) '("a bc def" "g"))
  (check-equal? (filled words 7) '("a bc" "def g")))

(test-case "the margin belongs to lines after the first, and counts"
  (check-equal? (filled words 7 "  ") '("a bc" "  def g"))
  (check-equal? (filled words 6 "  ") '("a bc" "  def" "  g")))

(test-case "a word that is too long has a line of its own; no words, no lines"
  (check-equal? (filled '("a" "long-word" "b") 4) '("a" "long-word" "b"))
  (check-equal? (filled '() 4) '()))
