#lang racket/base
;; Bessel functions against values of 30 digits, computed with 50, and their derivatives.

(require mechanics "../support/checks.rkt")

;; order, argument, and J, Y, I, K there; #f is not asked
(define table
  '(
   (0 1/2 "0.9384698072408129042284046736" "-0.444518733506706557148398475068"
       "1.06348337074132351926318441545" "0.92441907122766586178192416753")
   (0 10 "-0.245935764451348335197760862485" "0.0556711672835993914244598774102"
       "2815.71662846625447146981115343" "0.0000177800623161676518113011927995")
   (1 5/2 "0.497094102464274038010816276264" "0.145918137966785798878759940536"
       "2.51671624528869844152819174812" "0.0738908163477470636489935405912")
   (3 100 "0.0762842017203319434092902108933" "0.023445786687760911560229298375"
       "1.02627401756519005825032184553e+42" "4.869862747792454894749354489e-45")
   (1/3 2 "0.442939818148576212250422417736" "0.343199966260344342261499177313"
       "2.1587825813728630239501980169" "0.116544961296165248758942628915")
   (5/2 7 "-0.283436651201699198215614814451" "0.128523747808956547769125423624"
       "104.613367572348712519518479858" "0.000643541154481307574083629892842")
   (29/4 1/10 "4.40897556275496693494470473081e-14" "-995901867823.730954647540319609"
       "4.41164847905118204967289033247e-14" "1563108009084.46801370513557684")
   (20 15 "0.00736023407922348525831897679535" "-3.30873309247376447375219939827"
       "1.6470152535015824543953133179" "0.01214125772973115018528744496")
   (50 90 "0.0908020998380322803220628520685" "-0.0161642377016518222621274770133"
       "6.19460503617815025429654960546e+31" "7.83975964867157364948655891334e-35")
   (100 40 "2.38660629960262190646418779691e-30" "-1455243943810251866482495655.04"
       "6.62493802225961390346192959928e-27" "700740232977757020687937.055603")
   (-1/3 3/2 "0.234899528264702283364275739618" "0.600078093161681509734820688486"
       "1.62280829621638094725025596275" "0.220157690267766871113229565885")
   (-7/2 4 "-0.348902097875281903934500094238" "-0.365820269842407504262484185874"
       "2.19876967807692637583105967731" "0.0421444027422326962023300396774")
   (-3 2 "-0.128943249474402051098793332969" "1.12778377684042778608158395773"
       "0.212739959239852655272354393376" "0.647385390948634153159235570971")
   (1/4 1/1000000 "0.0293373861588554245815589335629" "-43.3705598589527070504227810356"
       "0.0293373861588671595360224780797" "68.1072278897349465009723200865")
   (2 30000 "0.00455730013847390797382530625614" "0.000672067385754422536502954417811"
       #f #f)))

(define (exact text) (string->number (string-append "#e" text)))

(define-check (check-digits found expected size)
  (unless (<= (abs (- (inexact->exact found) expected)) (* 4e-14 size))
    (with-check-info (['found found] ['expected (exact->inexact expected)]) (fail-check))))

(test-case "values of 13 digits, of J and Y relative to their common size"
  (for ([row (in-list table)])
    (define-values (n x j y i k) (apply values row))
    (with-check-info (['order n] ['at x])
      (define-values (J Y) (values (exact j) (exact y)))
      (define size (if (and (< (abs n) x) (> x 1)) (sqrt (+ (square J) (square Y))) #f))
      (check-digits (Bessel-J n x) J (or size (abs J)))
      (check-digits (Bessel-Y n x) Y (or size (abs Y)))
      (when i (check-digits (Bessel-I n x) (exact i) (abs (exact i))))
      (when k (check-digits (Bessel-K n x) (exact k) (abs (exact k)))))))

(test-case "spherical ones are elementary"
  (for ([x (in-list '(0.1 1.5 -2.5 40.0))])
    (define (check found expected) (check-= found expected (* 1e-13 (+ 1 (abs expected)))))
    (check (spherical-Bessel-j 0 x) (/ (sin x) x))
    (check (spherical-Bessel-j 1 x) (- (/ (sin x) (square x)) (/ (cos x) x)))
    (check (spherical-Bessel-y 0 x) (- (/ (cos x) x)))
    (check (spherical-Bessel-y 1 x) (- (/ (cos x) (square x) -1) (/ (sin x) x))))
  (check-equal? (spherical-Bessel-j 0 0) 1.0)
  (check-equal? (spherical-Bessel-j 3 0) 0.0))

(test-case "at zero, and of negative numbers"
  (check-equal? (Bessel-J 0 0) 1.0)
  (check-equal? (Bessel-J 5/2 0) 0.0)
  (check-equal? (Bessel-I 0 0) 1.0)
  (check-= (Bessel-J 3 -2) (- (Bessel-J 3 2)) 0.0)
  (check-= (Bessel-I 2 -2) (Bessel-I 2 2) 0.0)
  (check-= (Bessel-J -3 2) (- (Bessel-J 3 2)) 1e-16))

;; x² f'' + x f' ± (x² ∓ ν²) f = 0
(test-case "derivatives satisfy Bessel's equations, and Taylor series do"
  (for* ([n (in-list '(0 1/3 2 7/2))] [x (in-list '(0.7 3.0 12.0))])
    (define (residual f sign)
      (define (at order) (((expt D order) (lambda (x) (f n x))) x))
      (+ (* x x (at 2)) (* x (at 1)) (* (- (* sign x x) (* n n)) (at 0))))
    (for ([f (in-list (list Bessel-J Bessel-Y))]) (check-= (residual f 1) 0.0 1e-10))
    (for ([f (in-list (list Bessel-I Bessel-K))])
      (check-= (/ (residual f -1) (f n x)) 0.0 1e-10)))
  (for ([f (in-list (list spherical-Bessel-j spherical-Bessel-y))] #:when #t [n (in-list '(0 1 3))])
    (define (at order) (((expt D order) (lambda (x) (f n x))) 1.7))
    (check-= (+ (* 1.7 1.7 (at 2)) (* 2 1.7 (at 1)) (* (- (* 1.7 1.7) (* n (+ n 1))) (at 0)))
             0.0 1e-11))
  (check-= ((D (lambda (x) (spherical-Bessel-j 1 x))) 0) 1/3 1e-15))

(test-case "orders and arguments that have no real value are refused"
  (define-syntax-rule (check-refused pattern call) (check-exn pattern (lambda () call)))
  (check-refused #rx"^Bessel-J: of a negative number it is real for whole orders alone; given"
                 (Bessel-J 1/2 -1))
  (check-refused #rx"^Bessel-Y: expected a positive number, for it is infinite" (Bessel-Y 0 0))
  (check-refused #rx"^Bessel-K: expected a positive number" (Bessel-K 1 -1))
  (check-refused #rx"^Bessel-J: expected a finite real number\n  given: the symbol x"
                 (Bessel-J 0 'x))
  (check-refused #rx"^Bessel-I: expected a finite real number" (Bessel-I 0 +inf.0))
  (check-refused #rx"^Bessel-J: expected a real number below 100000 in size as order"
                 (Bessel-J 'n 1))
  (check-refused #rx"^Bessel-J: has no derivative by its order"
                 ((D (lambda (n) (Bessel-J n 1.5))) 1))
  (check-refused #rx"^Bessel-Y: the value at 0.001, of order 200, is too great" (Bessel-Y 200 1e-3))
  (check-refused #rx"^Bessel-I: the value at 800, of order 0, is too great" (Bessel-I 0 800))
  (check-refused #rx"^spherical-Bessel-j: expected a natural number as order"
                 (spherical-Bessel-j 1/2 1)))
