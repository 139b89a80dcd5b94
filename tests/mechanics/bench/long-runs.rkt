#lang racket/base
;; How the error of the energy grows over a million periods:
;;
;;     racket long-runs.rkt [--periods N] [--starts N] [--method NAME] [--system NAME]
;;
;; A motion is followed from several starts, next to each other, as far as that many periods.
;; Of each decade of the time, 10³ periods, 10⁴ and so on, the relative error of the energy is
;; taken at the ends of the steps within its last tenth; the root of the mean square over these
;; and over the starts is what stands in the table of the manual (Which method).  The exponent of
;; the growth is the slope of a straight line through the logarithms: 1/2 if rounding goes with
;; either sign as often, 1 if it has a bias.

(require racket/cmdline racket/flonum racket/list racket/string
         (only-in mechanics/motion/system/make-system make-system)
         mechanics/motion/integration-plan mechanics/motion/system/system
         mechanics/numeric/ode/integrate
         (only-in mechanics/value/shape structure->flvector)
         mechanics
         "clock.rkt")

(provide long-runs-heading long-runs-rows)

;; derivative : of states; start : k -> the one to begin with; energy : of a state as an flvector
;; period : of the motion; step : of the symplectic method
(struct long-run (name derivative start energy period step) #:authentic)

(define 2pi (* 2.0 pi))

;; ---------------------------------------------------------------------------
;; The motions

;; An ellipse of eccentricity 0.3 and half axis 1, from its end that is nearer to the centre.
(define Kepler
  (long-run "Kepler"
            (lambda (s)
              (define r (coordinate s))
              (up 1 (velocity s) (* -1 (/ r (expt (square r) 3/2)))))
            (lambda (k)
              (define e (+ 0.3 (* k 1e-6)))
              (up 0.0 (up (- 1.0 e) 0.0) (up 0.0 (sqrt (/ (+ 1.0 e) (- 1.0 e))))))
            (lambda (y)
              (define (at k) (flvector-ref y k))
              (fl- (fl* 0.5 (fl+ (sq (at 3)) (sq (at 4))))
                   (fl/ 1.0 (flsqrt (fl+ (sq (at 1)) (sq (at 2)))))))
            2pi
            (/ 2pi 200)))

;; Energy 1/12; a turn of either coordinate alone, of small amplitude, takes 2π.
(define Henon-Heiles
  (long-run "Hénon–Heiles"
            (lambda (s)
              (define-values (x y) (values (ref s 1 0) (ref s 1 1)))
              (up 1 (ref s 2) (up (- 0 x (* 2 x y)) (- (* y y) (* x x) y))))
            (lambda (k)
              (define y (+ 0.1 (* k 1e-6)))
              (define vx (sqrt (* 2.0 (- 1/12 (- (* 0.5 y y) (/ (* y y y) 3.0))))))
              (up 0.0 (up 0.0 y) (up vx 0.0)))
            (lambda (s)
              (define (at k) (flvector-ref s k))
              (define-values (x y) (values (at 1) (at 2)))
              (fl+ (fl* 0.5 (fl+ (fl+ (sq (at 3)) (sq (at 4))) (fl+ (sq x) (sq y))))
                   (fl- (fl* (fl* x x) y) (fl/ (fl* (fl* y y) y) 3.0))))
            2pi
            (/ 2pi 50)))

(define (sq x) (fl* x x))

(define systems (list Kepler Henon-Heiles))

(define methods
  (list (cons "Taylor" (lambda (_) 'Taylor))
        (cons "Dormand-Prince-853" (lambda (_) 'Dormand-Prince-853))
        (cons "Yoshida-8" (lambda (r) (Yoshida-8 (long-run-step r))))))

;; ---------------------------------------------------------------------------
;; One motion

;; Mean squares of the relative error in the last tenth of each decade; the last errors there;
;; and milliseconds
(define (follow r method k ends)
  (define start ((long-run-start r) k))
  (define m (plan-method (make-plan 'long-run 1e-15 method)))
  (define s (make-system 'long-run (long-run-derivative r) start))
  (define y (structure->flvector start values))
  (define energy (long-run-energy r))
  (define E (energy y))
  (define windows
    (for/list ([n (in-list ends)])
      (define end (fl* (->fl n) (long-run-period r)))
      (window (fl* 0.9 end) end 0.0 0 0.0)))
  (define left windows)
  (define now y)
  (define (visit from to interpolant)
    (define w (car left))
    (cond [(fl> to (window-end w)) (set! left (cdr left))]
          [(fl> to (window-from w)) (note! w (fl/ (fl- (energy now) E) E))])
    #t)
  (define-values (_ ms)
    (call/cpu
     (lambda ()
       (integrate-there s m y (window-end (last windows))
                        (lambda (state) (set! now state)) visit))))
  (values windows ms))

(define (integrate-there s m y end begun visit)
  (define-values (_ last)
    (integrate (system-method s m) (system-right-hand-side s m) y 0.0 end
               #:tolerance 1e-15 #:clock 0 #:begun begun #:visit visit))
  last)

;; from, end : times; squares : sum of the squares of count errors; latest : of the errors
(struct window (from end [squares #:mutable] [count #:mutable] [latest #:mutable]) #:authentic)

(define (note! w error)
  (set-window-squares! w (fl+ (window-squares w) (sq error)))
  (set-window-count! w (+ 1 (window-count w)))
  (set-window-latest! w error))

(define (mean-square w) (/ (window-squares w) (window-count w)))

;; ---------------------------------------------------------------------------
;; Many

;; means : by decade, the root of the mean square; seconds : of CPU for one
(struct outcome (means seconds) #:authentic)

(define (outcome-of r method starts ends [report void])
  (define-values (squares ms)
    (for/fold ([squares (map (lambda (_) 0.0) ends)] [all 0.0]) ([k (in-range starts)])
      (define-values (windows ms) (follow r method k ends))
      (report k windows ms)
      (values (map + squares (map mean-square windows)) (+ all ms))))
  (outcome (for/list ([x (in-list squares)]) (sqrt (/ x starts))) (/ ms starts 1000.0)))

;; Slope of log error against log time, by least squares.
(define (exponent ends errors)
  (define xs (map log ends))
  (define ys (map log errors))
  (define (mean zs) (/ (apply + zs) (length zs)))
  (define-values (x y) (values (mean xs) (mean ys)))
  (/ (for/sum ([a (in-list xs)] [b (in-list ys)]) (* (- a x) (- b y)))
     (for/sum ([a (in-list xs)]) (* (- a x) (- a x)))))

(define (decades most)
  (for/list ([k (in-range 3 10)] #:when (<= (expt 10 k) most)) (expt 10 k)))

;; ---------------------------------------------------------------------------
;; Shown

(define long-runs-heading
  '("error of the energy" "method" "10³ periods" "10⁴" "growth" "CPU s for 10⁴"))

(define (long-runs-rows)
  (for*/list ([r (in-list systems)] [m (in-list methods)])
    (define o (outcome-of r ((cdr m) r) 4 '(1000 10000)))
    `(,(long-run-name r) ,(car m)
      ,@(map two-digits (outcome-means o))
      ,(two-digits (exponent '(1000 10000) (outcome-means o)))
      ,(two-digits (outcome-seconds o)))))

(define (print-outcome r name method starts ends)
  (define (report k windows ms)
    (printf "  ~a, ~a, start ~a: ~a; ~a ms\n" (long-run-name r) name k
            (string-join (map two-digits (map window-latest windows))) (round ms))
    (flush-output))
  (define o (outcome-of r method starts ends report))
  (printf "~a, ~a, ~a starts: ~a; growth ~a; CPU ~a s each\n"
          (long-run-name r) name starts
          (string-join (for/list ([n (in-list ends)] [x (in-list (outcome-means o))])
                         (format "~a: ~a" n (two-digits x))))
          (if (pair? (cdr ends)) (two-digits (exponent ends (outcome-means o))) "–")
          (two-digits (outcome-seconds o)))
  (flush-output))

(define (two-digits x)
  (define size (abs x))
  (cond [(and (< 0.01 size) (< size 1000.0)) (number->string (/ (round (* 100.0 x)) 100.0))]
        [(zero? x) "0"]
        [else
         (define e (floor (/ (log size) (log 10.0))))
         (format "~ae~a" (/ (round (* 10.0 (/ x (expt 10.0 e)))) 10.0) (inexact->exact e))]))

(module+ main
  (define-values (periods starts wanted-method wanted-system) (values 10000 8 #f #f))
  (command-line
   #:program "long-runs"
   #:once-each
   [("--periods") n "as far as that (10000)" (set! periods (string->number n))]
   [("--starts") n "of each motion (8)" (set! starts (string->number n))]
   [("--method") name "only that" (set! wanted-method name)]
   [("--system") name "only that, Kepler or Hénon–Heiles" (set! wanted-system name)])
  (for* ([r (in-list systems)]
         #:when (or (not wanted-system) (equal? wanted-system (long-run-name r)))
         [m (in-list methods)]
         #:when (or (not wanted-method) (equal? wanted-method (car m))))
    (print-outcome r (car m) ((cdr m) r) starts (decades periods))))
