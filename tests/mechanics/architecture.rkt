#lang racket/base
;; The floors of the house: who may require whom, as the map has it (mechanics/README.md),
;; and habits of the source that can be checked by reading it.
;;
;; Each rule is also run on a made-up violation, so that it is known to find one.

(require racket/file
         racket/path
         racket/runtime-path
         "support/checks.rkt" "support/house/graph.rkt"
         "support/house/habits.rkt"
         "support/house/library.rkt"
         "support/house/map.rkt"
         "support/house/room-page.rkt")

(define-runtime-path fixture "runner/fixture/requiring.rkt")

(define longest-file 500)
(define longest-function 30)

;; Tables of coefficients or names, and formulas that are one.
(define tables
  '(dormand-prince-853-formulas notations replacements functions same-words phrases))



;; Rooms that know nothing of others, though those are below them.
(define strangers
  '(("show/display/" "lagrangian/" "force/" "motion/" "constraint/" "dynamics/" "question/")))

;; Names that two files may have, since the room says of what they are.
(define told-by-the-room '("on-demand.rkt" "arithmetic.rkt" "factor.rkt"))

;; ---------------------------------------------------------------------------
;; The rules find made-up violations

(define (check-sentences found expected)
  (check-equal? (sort found string<?) expected))

(define made-up-rooms
  (parse-rooms
   (string-append "- `numeric/`: numbers\n- `numeric/ode/`: steps\n- `algebra/`: forms\n"
                              "- `value/`: kinds\n  - `value/series/`: endless\n"
                              "- `lagrangian/`: systems\n- `display/`: showing\n"
                              "- `main.rkt`, `base.rkt`: facades\n- `book/`, `book.rkt`: objects\n")))

(test-case "rooms are read off the map in their order, and a file is in the nearest"
  (check-equal? made-up-rooms
                '(("numeric/") ("numeric/ode/") ("algebra/") ("value/") ("lagrangian/")
                  ("display/") ("main.rkt" "base.rkt") ("book/" "book.rkt")))
  (define (place name) (room-of name made-up-rooms))
  (check-equal? (map place '("numeric/a.rkt" "numeric/ode/a.rkt" "value/series/a.rkt" "base.rkt"))
                '(0 1 3 6))
  (check-false (place "attic/b.rkt")))

(test-case "a require from a later room is found"
  (define graph
    (hash "numeric/a.rkt" '("value/b.rkt")
          "value/b.rkt" '("numeric/c.rkt" "value/series/d.rkt")
          "value/series/d.rkt" '("value/b.rkt")
          "numeric/c.rkt" '("numeric/ode/d.rkt")
          "algebra/d.rkt" '("main.rkt")         ; to a facade
          "display/e.rkt" '("value/b.rkt" "lagrangian/f.rkt")
          "lagrangian/f.rkt" '("attic/g.rkt")
          "main.rkt" '("display/e.rkt" "book.rkt")
          "book.rkt" '("book/h.rkt")
          "book/h.rkt" '("main.rkt")))
  (check-sentences (upward-requires graph '(("display/" "lagrangian/")) made-up-rooms)
                   '("algebra/d.rkt requires main.rkt"
                     "display/e.rkt requires lagrangian/f.rkt"
                     "lagrangian/f.rkt requires attic/g.rkt"
                     "main.rkt requires book.rkt"
                     "numeric/a.rkt requires value/b.rkt"
                     "numeric/c.rkt requires numeric/ode/d.rkt")))

(test-case "a circle is found, and what only leads to it is not blamed"
  (check-sentences (circles
                    (hash "value/a.rkt" '("value/b.rkt") "value/b.rkt" '("value/c.rkt")
                          "value/c.rkt" '("value/a.rkt") "value/d.rkt" '("value/a.rkt")))
                   '("value/a.rkt requires itself in the end"
                     "value/b.rkt requires itself in the end"
                     "value/c.rkt requires itself in the end")))

(test-case "a file that is in no room is found"
  (check-sentences (unplaced-files (hash "value/a.rkt" '() "attic/b.rkt" '() "main.rkt" '())
                                   made-up-rooms)
                   '("attic/b.rkt is in no room of the map")))

(define (module-of name text)
  (read-module (open-input-string (string-append "#lang racket/base\n" text)) name))

(test-case "habits to avoid are found where they stand"
  (define (of rule name text) (rule name (module-of name text)))
  (check-equal? (of wholesale-provides "value/a.rkt" "(provide (all-defined-out))")
                '("value/a.rkt:2: all-defined-out hides what the module is for"))
  (check-equal? (of bare-errors "value/a.rkt" "(define (f)\n (error \"no\"))\n(error 'f \"yes\")")
                '("value/a.rkt:3: (error \"...\") does not say who complains"))
  (check-equal? (of Racket-complaints "value/a.rkt" "(raise-arguments-error 'f \"no\")")
                '("value/a.rkt:2: raise-arguments-error; use complain-showing"))
  (check-equal? (of dynamic-requires "value/a.rkt" "(dynamic-require 'x 'y)")
                '("value/a.rkt:2: dynamic-require hides a dependency; use require-on-demand"))
  (check-equal? (of assigned-exports "value/a.rkt"
                    "(provide a (rename-out [b c]))\n(set! a 1)\n(set! b 1)\n(set! d 1)")
                '("value/a.rkt:3: set! on a, which is exported"
                  "value/a.rkt:4: set! on b, which is exported"))
  (define outward "a path that leads out of the library; require a collection")
  (check-equal? (of outward-requires "value/a.rkt"
                    "(require \"../error/b.rkt\"\n \"../../b.rkt\")")
                (list (string-append "value/a.rkt:3: " outward)))
  (check-equal? (of outward-requires "value/series/a.rkt" "(require (file \"/b.rkt\"))")
                (list (string-append "value/series/a.rkt:2: " outward)))
  (define facade "(require \"x.rkt\")\n(provide a)\n(module reader racket/base 1)\n(define a 1)")
  (check-equal? (of facade-code "main.rkt" facade)
                '("main.rkt:5: a facade holds only require and provide"))
  (check-equal? (of facade-code "book.rkt" facade)
                '("book.rkt:5: a facade holds only require and provide"))
  (check-equal? (of facade-code "value/main.rkt" facade) '()))

(test-case "an exception made by hand is found, and one that was caught may be raised again"
  (define text
    "(raise (exn:fail:contract \"f: no\" (current-continuation-marks)))\n(raise e)\n(raise (more e))")
  (check-equal? (handmade-raises "value/a.rkt" (module-of "value/a.rkt" text))
                '("value/a.rkt:2: an exception made by hand; use complain, or a failure of error/"))
  (check-equal? (handmade-raises "error/a.rkt" (module-of "error/a.rkt" text)) '())
  (define own "(struct exn:here exn:fail ())\n(raise (exn:here \"\" (current-continuation-marks)))")
  (check-equal? (handmade-raises "value/a.rkt" (module-of "value/a.rkt" own)) '()))

(test-case "a helper with two homes is found, whatever it is called there"
  (define (file name text) (cons name (module-of name text)))
  (check-equal?
   (twin-definitions
    (list (file "value/a.rkt"
                "(define (dot v w) (for/sum ([x v] [y w]) (* x y)))\n(define (id x) x)")
          (file "value/b.rkt"
                "(define (id x) x)\n\n(define (times a b) (for/sum ([x a] [y b]) (* x y)))")
          (file "value/c.rkt" "(define (times a b) (for/sum ([x b] [y a]) (* x y)))")))
   '("the same function: value/a.rkt:2, value/b.rkt:4"))
  (define (twins one other)
    (length (twin-definitions (list (file "value/a.rkt" one) (file "value/b.rkt" other)))))
  (for ([same '(("(define (f g v) (for/list ([x v] #:when x) (g x x (g v))))"
                 "(define (h a b) (for/list ([y b] #:when y) (a y y (a b))))")
                ("(define (f v) (let loop ([i v]) (if (= i 0) v (loop (- i 1)))))"
                 "(define (g n) (let again ([k n]) (if (= k 0) n (again (- k 1)))))")
                ("(define (f v) (for/vector #:length (g v) ([x (in-vector v)]) (h x)))"
                 "(define (k w) (for/vector #:length (g w) ([y (in-vector w)]) (h y)))")
                ("(define ((f a) b) (define c (+ a b)) (lambda (d) (* c c d)))"
                 "(define ((g x) y) (define z (+ x y)) (lambda (t) (* z z t)))"))])
    (check-equal? (apply twins same) 1 (car same)))
  (check-equal? (twins "(define (f . xs) (cons 'f xs))" "(define (g . ys) (cons 'g ys))") 0)
  (check-equal? (twins "(define (f v i) (vector-ref v i))" "(define (g w k) (vector-ref w k))") 0)
  (check-equal? (twins "(define (f v) (* (first v) 2))" "(define (g w) (* (first w) 2))") 1)
  (check-equal? (twins "(define (f v) (for/list ([x v]) (sqrt (+ x v 1))))"
                       "(define (f v) (for/list ([x v]) (sqrt (+ v x 1))))")
                0))

(test-case "a function that takes more than so many lines is found"
  (define text "(define ((f x) y)\n  (g x\n     y))\n(define table\n  '(1\n    2))\n(define (h) 1)")
  (check-equal? (long-functions "value/a.rkt" (module-of "value/a.rkt" text) 2 '(table))
                '("value/a.rkt:2: f takes 3 lines"))
  (check-equal? (long-functions "value/a.rkt" (module-of "value/a.rkt" text) 3 '()) '()))

(test-case "a file name of two concepts is found"
  (check-equal? (twin-names '("value/tape.rkt" "algebra/tape.rkt" "dynamics/on-demand.rkt"
                              "force/on-demand.rkt" "value/up.rkt")
                            '("on-demand.rkt"))
                '("one name for algebra/tape.rkt, value/tape.rkt")))

(test-case "a big room without a page, and a page that is not true, are found"
  (define helpers (for/list ([i 11]) (format "value/h~a.rkt" (+ i 10))))
  (define big
    (for/fold ([graph (hash "value/a.rkt" helpers "value/b.rkt" '("value/a.rkt")
                            "force/c.rkt" '("value/b.rkt"))])
              ([name (in-list helpers)])
      (hash-set graph name '())))
  (check-equal? (page-faults big (lambda (folder) #f))
                '("value/ has 13 modules and no README.md"))
  (define page
    (string-append "# Values\n\n## Doors\n- `b.rkt`: bees\n\n## Helpers\n"
                   (apply string-append
                          (for/list ([i 11]) (format "- `h~a.rkt`: help\n" (+ i 10))))))
  (check-equal? (page-faults big (lambda (folder) (string-append page "- `a.rkt`: ants\n"))) '())
  (check-sentences (page-faults big (lambda (folder) (string-append page "- `d.rkt`: dogs\n")))
                   '("value/README.md has d.rkt among its helpers"
                     "value/README.md lacks a.rkt among its helpers"))
  (check-equal? (page-faults big (lambda (folder) (string-append page "- `a.rkt`: ants:\n")))
                '("value/README.md breaks off: - `a.rkt`: ants:"))
  (check-sentences (page-faults (hash-set big "force/c.rkt" '("value/a.rkt"))
                                (lambda (folder) (string-append page "- `a.rkt`: ants\n")))
                   '("value/README.md has a.rkt among its helpers"
                     "value/README.md has b.rkt among its doors"
                     "value/README.md lacks a.rkt among its doors"
                     "value/README.md lacks b.rkt among its helpers")))

(test-case "requires are read at every phase, from submodules, and when on demand"
  (define (names read)
    (map (lambda (p) (path->string (file-name-from-path p))) (read (simple-form-path fixture))))
  (for ([name '("class.rkt" "list.rkt" "string.rkt" "on-demand.rkt" "date.rkt")])
    (check-not-false (member name (names imports)) name))
  (check-equal? (names on-demand-imports) '("date.rkt")))

;; ---------------------------------------------------------------------------
;; The library

(define names (library-files))

(define complaints
  (for*/hash ([name (in-list names)]
              [complaint (in-value (compiler-complaint name))]
              #:when complaint)
    (values name complaint)))

(define graph (require-graph (remove* (hash-keys complaints) names)))

(define forms
  (for/list ([name (in-list names)]) (cons name (read-file (full-path name)))))

(test-case "every file compiles"
  (check-equal? complaints (hash)))

(test-case "the library is there and its requires are seen"
  (check-not-false (member "algebra/expression/expression.rkt" names))
  (check-not-false (member "algebra/expression/operation.rkt"
                           (hash-ref graph "algebra/expression/expression.rkt")))
  (check-not-false (member "motion/evolve-trajectory.rkt" (hash-ref graph "motion/on-demand.rkt"))))

(test-case "every file is in a room of the map"
  (check-equal? (unplaced-files graph) '()))

(test-case "no file requires from a later room"
  (check-equal? (upward-requires graph strangers) '()))

(test-case "rooms that a rule names are there"
  (for* ([rule (in-list strangers)] [room (in-list rule)])
    (check-not-false (room-of room) room)
    (check-true (directory-exists? (full-path room)) room)))

(test-case "a room of more than a dozen modules has a page, and it is true"
  (define (page-of folder)
    (define file (build-path (full-path folder) "README.md"))
    (and (file-exists? file) (file->string file)))
  (check-equal? (page-faults graph page-of) '()))

(test-case "there is no circle"
  (check-equal? (circles graph) '()))

(test-case "the source keeps to the habits"
  (check-equal? (for*/list ([entry (in-list forms)]
                            [rule (in-list source-rules)]
                            [sentence (in-list (rule (car entry) (cdr entry)))])
                  sentence)
                '()))

;; The book defines a free particle's Hamiltonian in two of its sections, and so does book/.
(test-case "a helper has one home"
  (define (of-book? entry) (regexp-match? #rx"^book/" (car entry)))
  (check-equal? (twin-definitions (filter (lambda (entry) (not (of-book? entry))) forms)) '()))

(test-case "one concept, one file name"
  (check-equal? (twin-names names told-by-the-room) '()))

(test-case "no function is longer than 30 lines"
  (check-equal? (for*/list ([entry (in-list forms)]
                            [sentence (in-list (long-functions (car entry) (cdr entry)
                                                               longest-function tables))])
                  sentence)
                '()))

(test-case "no file is longer than 500 lines"
  (for ([name (in-list names)])
    (check-true (<= (length (file->lines (full-path name))) longest-file) name)))
