#lang racket/base
;; Systems exported as C: built by the compiler that is here, called, and compared with our own.

(require racket/flonum
         (only-in racket/list append* fourth index-where)
         racket/string
         mechanics/book
         mechanics/compile/Racket-code mechanics/scale/export/exported-system
         mechanics/value/shape
         mechanics
         tests/mechanics/support/exported tests/mechanics/support/random
         tests/mechanics/support/skip tests/mechanics/support/systems
         "../../support/checks.rkt")

(define-syntax-rule (with-compiler body ...)
  (skip-unless compiler? "exported C: there is no cc and make" body ...))

;; make : parameters -> state derivative; parameters : alist of symbols and numbers
(struct system (name make example parameters))

(define (symbols s) (map car (system-parameters s)))
(define (numbers s) (map cdr (system-parameters s)))
(define (general s) (apply (system-make s) (symbols s)))
(define (particular s) (apply (system-make s) (numbers s)))
(define (size s) (shape-length (system-example s)))
(define (numeric-example s)
  (flvector->structure (system-example s)
                       (for/flvector ([k (size s)]) (* 0.1 (->fl (+ k 1))))))

(define-syntax-rule (lagrangian name L example [symbol number] ...)
  (system name (lambda (symbol ...) (Lagrangian->state-derivative (L symbol ...))) example
          (list (cons 'symbol number) ...)))

(define (Henon-Heiles (up t (up x y) (down px py)))
  (+ (* 1/2 (+ (square px) (square py) (square x) (square y)))
     (* (square x) y) (* -1/3 (cube y))))

(define (saw-tooth (up t x v))
  (up 1 v (- (atan (sin (* 3 x)) (+ 2 (cos x))) (* 0.1 (abs v)) (expt (+ 2 (square x)) 0.3)
             (tanh x) (asinh v))))

(define (coordinates letter n)
  (apply up (for/list ([k n]) (string->symbol (format "~a~a" letter k)))))

(define systems
  (list
   (lagrangian "pendulum" L-pendulum (up 't 'theta 'thetadot) [g 9.81] [m 1.2] [l 0.7])
   (lagrangian "double_pendulum" L-double-pendulum (up 't (up 'a 'b) (up 'adot 'bdot))
               [m1 1.0] [m2 0.6] [l1 1.1] [l2 0.9] [g 9.8])
   (lagrangian "driven" L-periodically-driven-pendulum (up 't 'theta 'thetadot)
               [m 1.0] [l 1.0] [g 9.8] [A 0.1] [omega 19.8])
   (lagrangian "Kepler" L-Kepler-polar (up 't (up 'r 'phi) (up 'rdot 'phidot)) [GM 1.3] [m 0.5])
   (lagrangian "chain" (lambda (g) (L-chain 5 g))
               (up 't (up 'a 'b 'c 'd 'e) (up 'va 'vb 'vc 'vd 've)) [g 9.8])
   (lagrangian "long_chain" (lambda (g) (L-chain 10 g))
               (up 't (coordinates "q" 10) (coordinates "v" 10)) [g 9.8])
   ;; Its mass matrix is symmetric, and not positive definite.
   (lagrangian "indefinite" (lambda (m)
                              (lambda ((up t (up x y) (up vx vy)))
                                (- (* 1/2 (- (* m (square vx)) (* (+ 2 (cos x)) (square vy))))
                                   (cos (* x y)))))
               (up 't (up 'x 'y) (up 'vx 'vy)) [m 2.0])
   (system "Henon_Heiles" (lambda () (Hamiltonian->state-derivative Henon-Heiles))
           (up 't (up 'x 'y) (down 'px 'py)) '())
   (system "saw_tooth" (lambda () saw-tooth) (up 't 'x 'v) '())))

(define (export-it s use #:general? [general? #t])
  (call-with-export use (system-name s) (if general? (general s) (particular s))
                    (system-example s)
                    #:parameters (and general? (symbols s)) #:derivatives? #t))

(define (list->flvector xs) (apply flvector xs))

(define (random-state n) (for/flvector #:length n ([_ n]) (random-flonum)))

;; The same bits, or neither is a number.
(define (same? a b) (or (eqv? a b) (and (not (= a a)) (not (= b b)))))

(define (check-all same? found expected s y)
  (with-check-info (['system (system-name s)] ['state y] ['found found] ['expected expected])
    (check-true (for/and ([a (in-flvector found)] [b (in-flvector expected)]) (same? a b)))))

(define (joined y p)
  (list->flvector (append (flvector->list y) (flvector->list p))))

(define (flvector->list v) (for/list ([x (in-flvector v)]) x))

(define ((close-to tolerance) a b)
  (or (same? a b) (<= (abs (- a b)) (* tolerance (+ 1.0 (abs a) (abs b))))))

;; Racket's own hyperbolic functions are not those of C, and many unknowns are solved by rows.
(define (same-as-far-as s tolerance)
  (if (member (system-name s) '("saw_tooth" "long_chain")) (close-to tolerance) same?))

(define (error-text run)
  (with-handlers ([exn:fail? exn-message]) (run) "no error"))

(test-case "rates are those of our own code, to the last bit, at a thousand states of each"
  (with-compiler
   (for ([s systems])
     (define n (size s))
     (define p (list->flvector (numbers s)))
     (define e
       (make-exported 'test (general s) (system-example s) "test" (symbols s) #f))
     (define ours! ((program->maker (exported-slope e))))
     (export-it
      s
      (lambda (folder library)
        (define rates (exported-function library (format "~a_derivative" (system-name s)) n))
        (define expected (make-flvector n))
        (with-seed 4711
          (for ([_ 1000])
            (define y (random-state n))
            (ours! (joined y p) expected)
            (check-all (same-as-far-as s 1e-12) (rates y p) expected s y))))))))

(test-case "derivatives by variables and by parameters are D's"
  (with-compiler
   (for ([s systems])
     (define n (size s))
     (define names (symbols s))
     (define m (length names))
     (define (f all) ((apply (system-make s) (cdr (structure->list all))) (ref all 0)))
     (define example (apply up (numeric-example s) (numbers s)))
     (define by-all (compile-function (D f) example))
     (export-it
      s
      (lambda (folder library)
        (define J
          (exported-function library (format "~a_jacobian" (system-name s)) (* n (+ n m))))
        (define p (list->flvector (numbers s)))
        (with-seed 99
          (for ([_ 20])
            (define y (random-state n))
            (define columns (by-all (joined y p)))
            (define expected
              (for*/flvector #:length (* n (+ n m)) ([i n] [j (+ n m)])
                (flvector-ref columns (+ (* j n) i))))
            (check-all (close-to 1e-9) (J y p) expected s y))))))))

(test-case "motions take the steps of 'Dormand-Prince-853, to the last bit"
  (with-compiler
   (for ([s systems])
     (define f (particular s))
     (define start (numeric-example s))
     (define y (structure->flvector start error))
     (define tr (evolve-trajectory f start 6 #:method 'Dormand-Prince-853 #:tolerance 1e-9))
     (define times (for/list ([k 10]) (+ 0.1 (* 0.61 k))))
     (export-it
      s #:general? #f
      (lambda (folder library)
        (define name (format "~a_evolve" (system-name s)))
        (define-values (last status rows)
          (exported-evolve library name y (flvector) 6.0 1e-9 times))
        (check-equal? status 0)
        (check-all (same-as-far-as s 1e-7) last (structure->flvector (tr 6) error) s y)
        (define ours
          (apply append (for/list ([t times])
                          (for/list ([x (in-flvector (structure->flvector (tr t) error))]) x))))
        (define tolerance (if (eq? same? (same-as-far-as s 1)) 1e-14 1e-7))
        (check-all (close-to tolerance) rows (list->flvector ours) s y))))))

(test-case "many motions at once are each as alone, and one that fails leaves the others"
  (with-compiler
   (define s (fourth systems))          ; falls into the centre where it does not turn
   (define n (size s))
   (export-it
    s
    (lambda (folder library)
      (define count 100)
      (define p (list->flvector (append* (for/list ([_ count]) (numbers s)))))
      (define starts
        (for*/flvector #:length (* n count) ([k count] [i n])
          (vector-ref (vector 0.0 1.0 0.0 0.0 (if (= k 17) 0.0 (+ 0.5 (* 0.005 k)))) i)))
      (define-values (failed last codes)
        (exported-ensemble library "Kepler_ensemble" count starts p 3.0 1e-9))
      (check-equal? failed 1)
      (check-equal? (index-where codes positive?) 17)
      (for ([k count] #:unless (= k 17))
        (define y (for/flvector #:length n ([i n]) (flvector-ref starts (+ (* k n) i))))
        (define-values (alone status rows)
          (exported-evolve library "Kepler_evolve" y (list->flvector (numbers s)) 3.0 1e-9 '()))
        (check-all same? (for/flvector #:length n ([i n]) (flvector-ref last (+ (* k n) i)))
                   alone s y))
      (define-values (none nothing no-codes)
        (exported-ensemble library "Kepler_ensemble" 0 (flvector) (flvector) 3.0 1e-9))
      (check-equal? none 0)))))

(test-case "the program reads starts and writes states; without OpenMP it writes the same"
  (with-compiler
   (define s (car systems))
   (export-it
    s
    (lambda (folder library)
      (define program (build-path folder "pendulum"))
      (define input "0 1 0 9.81 1.2 0.7\n0 2 0 9.81 1.2 0.7\n")
      (define printed (run-in folder program "2" "1e-9" #:input input))
      (define ours
        (for/list ([theta '(1.0 2.0)])
          ((evolve-trajectory (particular s) (up 0.0 theta 0.0) 2
                              #:method 'Dormand-Prince-853 #:tolerance 1e-9)
           2)))
      (for ([line (string-split printed "\n")] [state ours])
        (for ([word (string-split line)] [x (in-flvector (structure->flvector state error))])
          (check-= (string->number word) x 1e-8)))
      (define broken (string-append (substring input 0 19) "0 1 x"))
      (check-regexp-match #rx"row 2: expected 6 numbers"
                          (error-text (lambda () (run-in folder program "2" #:input broken))))
      (check-regexp-match #rx"END" (error-text (lambda () (run-in folder program))))
      (run-in folder "make" "-s" "clean")
      (build-folder folder "OPENMP=")
      (check-equal? (run-in folder program "2" "1e-9" #:input input) printed)))))

(test-case "the code is clean under the sanitizers of the compiler"
  (with-compiler
   (define s (cadr systems))
   (export-it
    s
    (lambda (folder library)
      (run-in folder "make" "-s" "clean")
      (define flags
        (string-append "CFLAGS=-std=c99 -O1 -g -Wall -Wextra -Werror -fno-sanitize-recover "
                       "-fsanitize=address,undefined"))
      (define built?
        (with-handlers ([exn:fail? (lambda (e) #f)])
          (run-in folder "make" "-s" flags "OPENMP=" "double_pendulum") #t))
      (skip-unless built? "exported C: the compiler has no sanitizers"
        (define lines
          (apply string-append
                 (for/list ([k 50]) (format "0 ~a 1 0 0 1 0.6 1.1 0.9 9.8\n" (* 0.05 k)))))
        (define printed (run-in folder (build-path folder "double_pendulum") "3" #:input lines))
        (check-equal? (length (string-split printed "\n")) 50))))))
