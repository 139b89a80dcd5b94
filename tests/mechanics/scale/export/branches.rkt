#lang racket/base
;; Branches as tables, and as programs in C that go round their orbits.

(require mechanics
         racket/file racket/string
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/exported.rkt"
         "../../support/folder.rkt" "../../support/messages.rkt" "../../support/skip.rkt")

(define ((pendulum A) s)
  (up 1 (ref s 2) (+ (* -1 (sin (ref s 1))) (* -1/2 (ref s 2)) (* A (cos (* 2/3 (ref s 0)))))))
(define swings (continue-periodic-orbit pendulum (up 0 0.5 0) (* 3 :pi) 0.5 1 #:most-steps 5))
(define example (up 't 'theta 'rate))

(define (H s) (* 1/2 (+ (square (momentum s)) (square (coordinate s)) (expt (coordinate s) 4))))
(define vibrations
  (continue-periodic-orbit (Hamiltonian->state-derivative H) (up 0 0.1 0) 6.2 0.01 1
                           #:energy H #:most-steps 3))
(define rests (continue-equilibrium (lambda (p) (lambda (s) (up (- p (ref s 0))))) (up 0.0) 0 1))

(define (numbers file) (map string->number (string-split (file->string file))))

(test-case "a branch is a table: parameter, state, period, stability"
  (for ([b (list swings vibrations rests)]
        [names '((parameter t q v period stable) (parameter t q p period stable)
                 (parameter x0 stable))])
    (with-folder (folder)
      (define file (build-path folder "branch.npz"))
      (write-table b file)
      (define t (read-table file))
      (check-equal? (table-names t) names)
      (check-equal? (table-column t 'parameter) (branch-parameters b))
      (when (branch-periods b) (check-equal? (table-column t 'period) (branch-periods b)))
      (check-equal? (table-column t 'stable)
                    (map (lambda (s) (if s 1.0 0.0)) (branch-stabilities b))))))

;; Each orbit is back where it started after its period, at its parameter.
(define (check-orbits b example symbols)
  (with-folder (beside)
    (define folder (build-path beside "orbit"))
    (export-system b example #:name "orbit" #:folder folder #:parameters symbols)
    (build-folder folder)
    (define periods (numbers (build-path folder "periods.txt")))
    (check-equal? periods (branch-periods b))
    (for ([start (file->lines (build-path folder "starts.txt"))] [T periods]
          [state (branch-states b)])
      (define end (run-in folder (build-path folder "orbit") #:input start (number->string T)
                          "1e-12"))
      (check-close (cdr (map string->number (string-split end)))
                   (list (ref state 1) (ref state 2)) 1e-8))))

(skip-unless compiler? "exported branches: there is no cc and make"
  (test-case "the exported program goes round the orbits of a branch"
    (check-orbits swings example '(A))
    (check-orbits swings example #f)
    (check-orbits vibrations (up 't 'q 'p) #f)))

(says
 [(export-system swings example #:parameters '(A B))
  "export-system: a branch has one parameter, as in #:parameters '(A)\n  given: (A B)"])
