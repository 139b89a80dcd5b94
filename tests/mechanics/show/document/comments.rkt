#lang racket/base
;; Comments of a program as prose and headings.

(require "../../support/checks.rkt" "../../../../mechanics/show/document/comments.rkt"
         "../../../../mechanics/show/document/document-piece.rkt")

(define (text . lines) (apply string-append (map (lambda (l) (string-append l "\n")) lines)))

(test-case "lines of a paragraph are joined, paragraphs are parted"
  (check-equal? (gap->pieces (text ";; The first line is long enough to be full"
                                   ";; and goes on here." ";;" ";; Another."))
                (list (prose '(("The first line is long enough to be full and goes on here.")
                               ("Another."))))))

(test-case "a line that ended before it had to stays one, and so does an item of a list"
  (check-equal? (gap->pieces
                 (text ";; Checked: one"
                       ";; How: by two, in a line that is longer than the one above"))
                (list (prose '(("Checked: one"
                                "How: by two, in a line that is longer than the one above")))))
  (check-equal? (prose-paragraphs
                 (car (gap->pieces (text ";; A line that is full" ";; How: said in short"))))
                '(("A line that is full" "How: said in short")))
  (check-equal? (prose-paragraphs
                 (car (gap->pieces (text "; some words, and then" "; - an item" "; - another"))))
                '(("some words, and then" "- an item" "- another"))))

(test-case "a line beneath a rule is a heading"
  (check-equal? (gap->pieces (text ";; -------------------" ";; The motion" "" ";; In numbers."))
                (list (heading "The motion") (prose '(("In numbers.")))))
  (check-equal? (gap->pieces (text ";; ------------------")) '()))

(test-case "headings as in Markdown, and between or above rules"
  (check-equal? (gap->pieces (text ";; # The pendulum" ";; It swings." ";;"
                                   ";; ### Its energy ##" ";;#f"))
                (list (heading "The pendulum") (prose '(("It swings.")))
                      (heading "Its energy") (prose '(("#f")))))
  (check-equal? (gap->pieces (text "#|" "# The pendulum" "" "Words" "## More" "|#"))
                (list (heading "The pendulum") (prose '(("Words"))) (heading "More")))
  (check-equal? (gap->pieces (text ";; =======" ";; The motion" ";; =======" ";; In numbers."))
                (list (heading "The motion") (prose '(("In numbers.")))))
  (check-equal? (gap->pieces (text ";; The motion" ";; =======" ";; In numbers." "" ";; The end"
                                   ";; -------"))
                (list (heading "The motion") (prose '(("In numbers."))) (heading "The end")))
  (check-equal? (gap->pieces (text ";; Last words." ";; -------" ";; The motion" ""
                                   ";; ## " ";; #"))
                (list (prose '(("Last words."))) (heading "The motion") (prose '(("## #"))))))

(test-case "block comments are prose, with those inside; what #; leaves out is code"
  (check-equal? (gap->pieces "#| one\n#| two |# three |#")
                (list (prose '(("one #| two |# three")))))
  (check-equal? (gap->pieces "\n#;(f x)\n") (list (code "#;(f x)" 1)))
  (check-equal? (gap->pieces "#| not closed") (list (code "#| not closed" 1)))
  (check-equal? (gap->pieces " \n ") '()))

(define (title . paragraphs)
  (define-values (found rest) (take-title (list (prose paragraphs)) "file.rkt"))
  (list found rest))

(test-case "the first sentence is the title, if it is short"
  (check-equal? (title '("A pendulum. It swings."))
                (list "A pendulum" (list (prose '(("It swings."))))))
  (check-equal? (title '("A pendulum.")) '("A pendulum" ()))
  (check-equal? (title '("An orbit (p. 22) drawn. So."))
                (list "An orbit (p. 22) drawn" (list (prose '(("So."))))))
  (check-equal? (title '("How good is it?")) '("How good is it?" ()))
  (check-equal? (title '(".5 of a turn.")) '(".5 of a turn" ()))
  (define (letters n) (make-string n #\a))
  (check-equal? (title (list (letters 120))) (list (letters 120) '()))
  (check-equal? (title (list (letters 121)))
                (list "file.rkt" (list (prose (list (list (letters 121)))))))
  (define long (letters 200))
  (check-equal? (title (list long)) (list "file.rkt" (list (prose (list (list long)))))))

(test-case "a heading at the start is the title"
  (define-values (found rest)
    (take-title (gap->pieces ";; # The pendulum. Small\n;;\n;; Words.") "file.rkt"))
  (check-equal? (list found rest) (list "The pendulum. Small" (list (prose '(("Words.")))))))

(test-case "without an opening comment the file's name is"
  (define-values (found rest) (take-title (list (code "x" 0)) "file.rkt"))
  (check-equal? (list found rest) (list "file.rkt" (list (code "x" 0)))))

(test-case "forms with nothing between them stand together"
  (check-equal? (joined-code
                 (list (code "a" 1) (code "b" 0) (code "c" 1) (output "o") (code "d" 1)))
                (list (code "a\nb\n\nc" 1) (output "o") (code "d" 1))))
