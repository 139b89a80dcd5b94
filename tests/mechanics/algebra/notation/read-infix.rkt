#lang racket/base
;; What is written on one line is read back as the expression it was written from: it has the
;; same value everywhere, and is written alike again.
;;
;; `racket tests/mechanics/algebra/notation/read-infix.rkt 10000` is a long run.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/expression/read
         mechanics/algebra/expression/substitute
         mechanics/algebra/notation/formula
         mechanics/algebra/notation/infix
         mechanics/algebra/notation/read-infix
         racket/list
         rackunit
         "../../support/evaluate.rkt"
         (only-in "../../support/property/expressions.rkt" random-expression choose))

(define kinds
  '(rational trigonometric hyperbolic exponential power logarithm radical root nested inverse
    modulus literal flonum))

;; Names that look like each other, like operations and like nothing a formula has.
(define names
  '(theta theta_1 thetadot p_phi v^x_r xdotdot omega0 omega_0 D Dx sin e i pi :pi mass L-free
    |a b| |x+y| bar\| |</mi>| x^2 x_ab GM))

;; What divides by 0 when it is made again is left as it is.
(define (renamed e)
  (with-handlers ([exn:fail? (lambda (x) e)]) (with-other-names e)))

(define (with-other-names e)
  (substitute-expression e (map cons '(a b c x) (take (shuffle names) 4))))

(define (line e) (tree->line (datum->tree (expression->datum e) (current-way #f #t))))

;; ---------------------------------------------------------------------------
;; Values

;; A value for each symbol, and one that is smooth in the arguments for each function.
(define ((value-at seed) leaf arguments)
  (define key (if (symbol? leaf) leaf (head->datum (node-head leaf))))
  (define phase (/ (modulo (equal-hash-code (format "~s" (list seed key))) 1000) 1000.0))
  (for/fold ([v (make-rectangular (+ 0.4 phase) (- 0.7 (* 0.6 phase)))])
            ([x (in-list (flatten arguments))] #:when (number? x))
    (+ v (* 0.37 x))))

(define-syntax-rule (value-of expression seed)
  (value-from (lambda () expression) seed))

;; #f where there is none
(define (value-from make seed)
  (with-handlers ([exn:fail? (lambda (x) #f)])
    (define e (make))
    (define v (evaluate-expression e (value-at seed)))
    (and (number? v) (< (magnitude v) 1e8) v)))

(define (close? v w) (<= (magnitude (- v w)) (* 1e-6 (+ 1 (magnitude v)))))

;; ---------------------------------------------------------------------------

;; -> how many values could be compared
(define (check-random count seed)
  (random-seed seed)
  (for/sum ([k (in-range count)])
    (define e (renamed (random-expression (choose 1 2 3 4) kinds)))
    (check-one e k)))

(define (check-one e k)
  (define text (line e))
  (with-check-info (['expression e] ['text text])
    (define datum (infix->datum text))
    (check-equal? (tree->line (datum->tree datum (current-way #f #t))) text)
    (define v (value-of e k))
    (define w (value-of (datum->expression datum) k))
    (cond [(and v w)
           (check-true (close? v w) (format "~a and ~a" v w))
           1]
          [else 0])))

(define (check-many count seed)
  (define compared (check-random count seed))
  (check-true (> compared (* 0.6 count)) (format "~a of ~a had values" compared count))
  compared)

(test-case "random expressions are read back"
  (void (check-many 400 20250101)))

(test-case "a reader that is wrong about a sign, an exponent or a bar would be noticed"
  (define (differ a b)
    (check-false (close? (value-of (datum->expression a) 1) (value-of (datum->expression b) 1))))
  (differ '(- a b) '(+ a b))
  (differ '(expt a 2) '(expt a 3))
  (differ '(/ a (* b c)) '(* (/ a b) c)))

;; ---------------------------------------------------------------------------
;; To the letter

(define-syntax-rule (reads [text datum] ...)
  (begin (test-case text (check-equal? (infix->datum text) 'datum)) ...))

(reads
 ["½ m ẋ² − m g x" (+ (* 1/2 m (expt xdot 2)) (* -1 m g x))]
 ["m D²x(t)" (* m (((expt D 2) x) t))]
 ["∂₀∂_(1,0)²F(x, y)" (((* (partial 0) (expt (partial 1 0) 2)) F) x y)]
 ["a b/(c d)" (/ (* a b) (* c d))]
 ["sin θ cos² φ" (* (sin theta) (expt (cos phi) 2))]
 ["sin(θ)²" (expt (sin theta) 2)]
 ["x (t)" (* x t)]
 ["x(t)" (x t)]
 ["√2 √(x + 1)" (* (sqrt 2) (sqrt (+ x 1)))]
 ["1.5×10⁻¹⁰ + 2.5" (+ 1.5e-10 2.5)]
 ["e^(−γ t)" (expt e (* -1 gamma t))]
 ["[1, a; 0, up(x, down())]" (matrix-by-rows (list 1 a) (list 0 (up x (down))))]
 ["a − (b − c)" (+ a (* -1 (+ b (* -1 c))))]
 ["m > 0" (> m 0)]
 ["(3/7)i" 0+3/7i]
 ["a - b" (+ a (* -1 b))])

(module+ main
  (require racket/cmdline)
  (command-line
   #:args ([count "10000"])
   (printf "~a values compared\n" (check-many (string->number count) (random 1000000)))))
