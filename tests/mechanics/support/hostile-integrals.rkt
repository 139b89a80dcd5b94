#lang racket/base
;; Integrals chosen to be done wrong: with known values.
;;
;; The values are closed forms, or sums of such, computed with 50 digits, and are written here
;; with 30.  A parameter such as 0.7 is the flonum, exactly, there as here.

(require "integrals.rkt")

(provide hostile-integrals)

;; Jumps, and points without a value.
(define jumps
  (hard
   ["sgn(x − 1/π)"
    (lambda (x) (if (< x (/ 1 pi)) -1 1))
    -1 1 "-0.636619772367581382432888403855" 2]
   ["sgn(sin 20x) e^x"
    (lambda (x) (* (exp x) (if (< (sin (* 20 x)) 0) -1 1)))
    0 1 "0.0291823006559918833224427113437" 1.72]
   ["ten steps of 1/10"
    (lambda (x) (floor (* 10 x)))
    0 1 "4.5"]
   ["a box of width 10⁻² far from the middle"
    (lambda (x) (if (< 0.03 x 0.04) 1 0))
    0 1 "0.010000000000000001942890293094"]
   ["x sgn(x − 2)"
    (lambda (x) (if (< x 2) (- x) x))
    0 5 "8.5" 12.5]
   ["floor e^x"
    (lambda (x) (floor (exp x)))
    0 2 "5.47483863893458569983446896365"]
   ["x floor(1/x)"
    (lambda (x) (* x (floor (/ 1 x))))
    0.01 1 "0.812491950092446432332499600144"]
   ["x², NaN at 1/2"
    (lambda (x) (if (= x 1/2) +nan.0 (* x x)))
    0 1 "0.333333333333333333333333333333"]
   ["cos x, infinite at 0"
    (lambda (x) (if (= x 0) +inf.0 (cos x)))
    -1 1 "1.68294196961579301330500464326"]
   ["sin x/x, 0/0 at 0"
    (lambda (x) (/ (sin x) (exact->inexact x)))
    -3 3 "3.69730505599893651279546050222"]))

;; Several peaks, peaks on a ground, peaks at ends.
(define peaks
  (hard
   ["two Gaussians, 10⁻³ wide, 10⁻² apart"
    (lambda (x)
      (+ (exp (- (square (* 1000 (- x 0.6))))) (exp (- (square (* 1000 (- x 0.61)))))))
    0 1 "0.00354490770181103205459633496668"]
   ["a peak of width 10⁻³ from 0 to infinity"
    (lambda (x) (exp (- (square (* 1000 (- x 0.7123))))))
    0 +inf.0 "0.00177245385090551602729816748334"]
   ["Gaussian of width 10⁻⁶ at 0"
    (lambda (x) (exp (- (square (* 1e6 x)))))
    -1 1 "0.00000177245385090551602729816748334"]
   ["1 + Gaussian of width 5·10⁻⁴"
    (lambda (x) (+ 1 (exp (- (square (/ (- x 0.4711) 5e-4))))))
    0 1 "1.00088622692545275803209738757"]
   ["three Lorentz peaks"
    (lambda (x)
      (for/sum ([c '(0.1 0.5 0.9)] [w '(1e-3 1e-2 1e-4)]) (/ w (+ (* w w) (square (- x c))))))
    0 1 "9.372561404705228600876981874"]
   ["x² and a dip of width 10⁻³"
    (lambda (x) (- (* x x) (exp (- (square (* 1000 (- x 1.234)))))))
    0 2 "2.66489421281576115063936849918"]
   ["e^(−1000|x − 1/3|)"
    (lambda (x) (exp (* -1000 (abs (- x 1/3)))))
    0 1 "0.002"]
   ["sech²(700(x − 1/4)) on e^(−x)"
    (lambda (x) (+ (exp (- x)) (/ 1 (square (cosh (* 700 (- x 1/4)))))))
    0 1/2 "0.396326483144509433539057607866"]))

;; From minus infinity to infinity.
(define whole-lines
  (hard
   ["1/(1 + x²)²"
    (lambda (x) (/ 1 (square (+ 1 (* x x)))))
    -inf.0 +inf.0 "1.57079632679489661923132169164"]
   ["e^(−|x|)"
    (lambda (x) (exp (- (abs x))))
    -inf.0 +inf.0 "2.0"]
   ["e^(−x² + x)"
    (lambda (x) (exp (- x (* x x))))
    -inf.0 +inf.0 "2.27587579446874723551960576383"]
   ["x² e^(−x²)"
    (lambda (x) (* x x (exp (- (* x x)))))
    -inf.0 +inf.0 "0.886226925452758013649083741671"]
   ["1/(e^x + e^(−x))"
    (lambda (x) (/ 1 (+ (exp x) (exp (- x)))))
    -inf.0 +inf.0 "1.57079632679489661923132169164"]
   ["e^(x − e^x)"
    (lambda (x) (exp (- x (exp x))))
    -inf.0 +inf.0 "1.0"]
   ["e^(−x⁴)"
    (lambda (x) (exp (- (expt x 4))))
    -inf.0 +inf.0 "1.81280495411095415596534257793"]
   ["cos x/(1 + x²)"
    (lambda (x) (/ (cos x) (+ 1 (* x x))))
    -inf.0 +inf.0 "1.15572734979092171791009318331"]
   ["x sin x/(4 + x²)"
    (lambda (x) (/ (* x (sin x)) (+ 4 (* x x))))
    -inf.0 +inf.0 "0.425168331587636328439122361209"]
   ["1/(1 + |x|^3/2)"
    (lambda (x) (/ 1 (+ 1 (expt (abs x) 3/2))))
    -inf.0 +inf.0 "4.83679830462458093491754202038"]
   ["e^(−(x + 100)²)"
    (lambda (x) (exp (- (square (+ x 100)))))
    -inf.0 +inf.0 "1.77245385090551602729816748334"]
   ["sech(x − 20)"
    (lambda (x) (/ 1 (cosh (- x 20))))
    -300 +320 "3.14159265358979323846264338328"]))

;; Kinks, cusps and infinities inside.
(define cusps
  (hard
   ["|x − 1/π|^(1/3)"
    (lambda (x) (expt (abs (- x (/ 1 pi))) 1/3))
    0 1 "0.612966158493527004562429303805"]
   ["|x|^(1/10)"
    (lambda (x) (expt (abs x) 0.1))
    -1 1 "1.81818181818181817264278492045"]
   ["e^(−√|x|)"
    (lambda (x) (exp (- (sqrt (abs x)))))
    -1 1 "1.05696447062846142723580983871"]
   ["√(x (1 − x))"
    (lambda (x) (sqrt (* x (- 1 x))))
    0 1 "0.39269908169872415480783042291"]
   ["||x − 0.3| − 0.2|"
    (lambda (x) (abs (- (abs (- x 0.3)) 0.2)))
    0 1 "0.17000000000000000222044604925"]
   ["|sin 7x|^(1/2)"
    (lambda (x) (sqrt (abs (sin (* 7 x)))))
    0 3 "2.30558480226224669557166761656"]
   ["log|x² − 2|"
    (lambda (x) (log (abs (- (* x x) 2))))
    0 3 "1.28553049296590220931994127926" 2.6]
   ["|x|^(−1/2) sgn x across 0"
    (lambda (x) (/ (if (< x 0) -1 1) (sqrt (abs x))))
    -1 2 "0.828427124746190097603377448419" 4.83]
   ["|x − 0.7|^−0.9"
    (lambda (x) (expt (abs (- x 0.7)) -0.9))
    0 1 "18.5152924568503139351069496277"]
   ["√(1 − x^10)"
    (lambda (x) (sqrt (- 1 (expt x 10))))
    0 1 "0.943590581267979476787995412631"]))

;; Functions nearly infinite, just outside of the range.
(define nearly-infinite
  (hard
   ["1/√(x + 10⁻¹²)"
    (lambda (x) (/ 1 (sqrt (+ x 1e-12))))
    0 1 "1.99999800000100000000001986333"]
   ["1/(x + 10⁻⁸)"
    (lambda (x) (/ 1 (+ x 1e-8)))
    0 1 "18.4206807539523654012213713499"]
   ["log(x + 10⁻¹⁰)"
    (lambda (x) (log (+ x 1e-10)))
    0 1 "-0.999999997597414907000954232094"]
   ["1/(10⁻⁶ + 1 − cos x)"
    (lambda (x) (/ 1 (+ 1e-6 (* 2 (square (sin (/ x 2)))))))
    (- pi) pi "4442.88182743804832805066761927"]
   ["1/√(1 − 0.999999 x²)"
    (lambda (x) (/ 1 (sqrt (- 1 (* 0.999999 x x)))))
    0 1 "1.5697971115269675105162628021"]
   ["x^−0.99 from 10⁻³⁰"
    (lambda (x) (expt x -0.99))
    1e-30 1 "49.8812766372727579040403839922"]
   ["1/x from 10⁻³⁰ to 1"
    (lambda (x) (/ 1 x))
    1e-30 1 "69.0775527898213704372033230329"]
   ["1/(x (1 + x)) from 10⁻⁶"
    (lambda (x) (/ 1 (* x (+ 1 x))))
    1e-6 1 "13.1223643774038288402758926123"]
   ["tan x nearly to π/2"
    (lambda (x) (tan x))
    0 1.57 "7.13550101570792397971053984303"]
   ["the pendulum close to the top"
    (lambda (x) (/ 1 (sqrt (+ (square (cos x)) (* 1e-7 (square (sin x)))))))
    0 (/ pi 2) "9.44534239773242320872715709486"]))

;; Waves, to infinity or to a point.
(define waves
  (hard
   ["cos(50 sin x)"
    (lambda (x) (cos (* 50 (sin x))))
    0 pi "0.175339598585467849508025488557" 3]
   ["sin(200 x²)"
    (lambda (x) (sin (* 200 x x)))
    0 1 "0.0430988575136614159041250834366" 0.6]
   ["sin x/(x² + x)"
    (lambda (x) (/ (sin x) (+ x (* x x))))
    0 +inf.0 "0.949346702559083261592055963424" 1.0]
   ["e^(−x/5) cos x²"
    (lambda (x) (* (exp (* -1/5 x)) (cos (* x x))))
    0 +inf.0 "0.621025928868818373324721948026" 1.5]
   ["cos x²/(1 + x)"
    (lambda (x) (/ (cos (* x x)) (+ 1 x)))
    0 +inf.0 "0.533474457057648092952664419394" 0.9]
   ["sin x³/x"
    (lambda (x) (/ (sin (* x x x)) x))
    0 +inf.0 "0.523598775598298873077107230547"]
   ["sin(x)/x^1.9"
    (lambda (x) (/ (sin x) (expt x 1.9)))
    0 +inf.0 "10.4404229245968659083558962323"]
   ["cos(100 x)/√(1 + x)"
    (lambda (x) (/ (cos (* 100 x)) (sqrt (+ 1 x))))
    0 +inf.0 "0.0000499812794263421980286640583865" 0.05]
   ["sin(1/x²)"
    (lambda (x) (sin (/ 1 (* x x))))
    0 1 "0.285736646322852594910808230371" 0.6]
   ["sin(1/x)/√x"
    (lambda (x) (/ (sin (/ 1 x)) (sqrt x)))
    0 1 "0.571473292645705189821616460741" 0.9]
   ["e^(−x) sin(100 x)"
    (lambda (x) (* (exp (- x)) (sin (* 100 x))))
    0 +inf.0 "0.009999000099990000999900009999" 0.64]
   ["sin²(x)/x^(3/2)"
    (lambda (x) (/ (square (sin x)) (expt x 3/2)))
    0 +inf.0 "1.77245385090551602729816748334"]
   ["(1 − cos x)/x^5/2"
    (lambda (x) (/ (* 2 (square (sin (/ x 2)))) (expt x 5/2)))
    0 +inf.0 "1.67108551642066700161051018987"]
   ["sin x sin 2x/x"
    (lambda (x) (/ (* (sin x) (sin (* 2 x))) x))
    0 +inf.0 "0.549306144334054845697622618461" 1]))

;; Very large and very small numbers.
(define scales
  (hard
   ["e^(−x/10³⁰)"
    (lambda (x) (exp (/ x -1e30)))
    0 +inf.0 "1.00000000000000001988462483866e+30"]
   ["e^(−10³⁰ x)"
    (lambda (x) (exp (* -1e30 x)))
    0 +inf.0 "9.99999999999999980115375161344e-31"]
   ["10³⁰ sin x"
    (lambda (x) (* 1e30 (sin x)))
    0 pi "2.00000000000000003976924967731e+30"]
   ["10⁻³⁰ sin x"
    (lambda (x) (* 1e-30 (sin x)))
    0 pi "2.00000000000000016667284121517e-30"]
   ["10⁻³⁰⁰ e^x"
    (lambda (x) (* 1e-300 (exp x)))
    0 1 "1.71828182845904527841886960948e-300"]
   ["10²⁵⁰/√x"
    (lambda (x) (/ 1e250 (sqrt x)))
    0 1 "1.99999999999999984219366616643e+250"]
   ["x² on ±10⁻³⁰"
    (lambda (x) (* x x))
    -1e-30 1e-30 "6.66666666666666833339507881839e-91"]
   ["1/√x to 10³⁰"
    (lambda (x) (/ 1 (sqrt x)))
    0 1e30 "2000000000000000.01988462483866"]
   ["1/(10⁶⁰ + x²)"
    (lambda (x) (/ 1 (+ 1e60 (* x x))))
    -inf.0 +inf.0 "3.1415926535897933179651453472e-30"]
   ["1/(10⁻⁶⁰ + x²)"
    (lambda (x) (/ 1 (+ 1e-60 (* x x))))
    -inf.0 +inf.0 "3.14159265358979328490564966458e+30"]
   ["e^(−x²/10²⁰)"
    (lambda (x) (exp (- (square (/ x 1e10)))))
    -inf.0 +inf.0 "17724538509.0551602729816748334"]
   ["cos(10⁻⁶ x) e^(−10⁻⁶ x)"
    (lambda (x) (* (cos (* 1e-6 x)) (exp (* -1e-6 x))))
    0 +inf.0 "500000.000000000022625944087057"]
   ["sin x near 10⁶"
    (lambda (x) (sin x))
    1e6 (+ 1e6 10) "1.91315802140328843646722235731" 6.4]
   ["1/x from 10¹⁰ to 10³⁰"
    (lambda (x) (/ 1 x))
    1e10 1e30 "46.0517018598809137002444539323"]
   ["x⁻² from 10¹⁰"
    (lambda (x) (/ 1 (* x x)))
    1e10 +inf.0 "1.0e-10"]
   ["x⁻² from 10⁻¹⁰"
    (lambda (x) (/ 1 (* x x)))
    1e-10 +inf.0 "9999999999.99999963567802684502"]
   ["log x/√x to 10⁻¹⁰"
    (lambda (x) (/ (log x) (sqrt x)))
    0 1e-10 "-0.000500517018598809145192421735305"]))

;; Others that books have.
(define others
  (hard
   ["x⁴ e^x/(e^x − 1)²"
    (lambda (x) (/ (* (expt x 4) (exp x)) (square (- (exp x) 1))))
    0 5 "15.3597843168821829816796833679"]
   ["1/(1 + 0.99 cos x)²"
    (lambda (x) (/ 1 (square (+ 1 (* 0.99 (cos x))))))
    0 (* 2 pi) "2238.20702102720126544335832308"]
   ["log sin x log cos x"
    (lambda (x) (* (log (sin x)) (log (cos x))))
    0 (/ pi 2) "0.108729731954001885202371316483"]
   ["x^(−x)"
    (lambda (x) (expt x (- x)))
    0 1 "1.2912859970626635404072825906"]
   ["e^(−1/x)/x²"
    (lambda (x) (/ (exp (/ -1 x)) (* x x)))
    0 1 "0.367879441171442321595523770161"]
   ["e^(−1/x²)"
    (lambda (x) (exp (/ -1 (* x x))))
    -1 1 "0.178147711781560690192582318168"]
   ["1/(1 + x^100)"
    (lambda (x) (/ 1 (+ 1 (expt x 100))))
    0 +inf.0 "1.00016451234931271403774362365"]
   ["x e^(−x) sin x"
    (lambda (x) (* x (exp (- x)) (sin x)))
    0 +inf.0 "0.5" 1]
   ["x^5/(e^x − 1)"
    (lambda (x) (/ (expt x 5) (- (exp x) 1)))
    0 +inf.0 "122.081167438133896765742151575"]
   ["log(1 − e^(−x))"
    (lambda (x) (log (- 1 (exp (- x)))))
    0 +inf.0 "-1.64493406684822643647241516665"]
   ["x^−1/2/(1 + x)"
    (lambda (x) (/ 1 (* (sqrt x) (+ 1 x))))
    0 +inf.0 "3.14159265358979323846264338328"]
   ["x^−0.99/(1 + x)"
    (lambda (x) (/ (expt x -0.99) (+ 1 x)))
    0 +inf.0 "100.016451234931182600547389433"]
   ["1/√(x⁴ + x)"
    (lambda (x) (/ 1 (sqrt (+ (expt x 4) x))))
    0 +inf.0 "2.8043642106509085223500381581"]
   ["1/((x − 1)^(2/3) x)"
    (lambda (x) (/ 1 (* x (expt (- x 1) 2/3))))
    1 +inf.0 "3.62759872846843570118815651528"]
   ["1/(x √(x² − 1))"
    (lambda (x) (/ 1 (* x (sqrt (- (* x x) 1)))))
    1 +inf.0 "1.57079632679489661923132169164"]
   ["1/(x √log x)"
    (lambda (x) (/ 1 (* x (sqrt (log x)))))
    1 2 "1.66510922231539551270632928979"]))

(define hostile-integrals
  (append jumps peaks whole-lines cusps nearly-infinite waves scales others))
