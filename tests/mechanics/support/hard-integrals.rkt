#lang racket/base
;; Difficult integrals with known values.
;;
;; The values were computed with 50 digits, from closed forms where there are such and by
;; quadrature in that precision elsewhere, and are written here with 30.  A parameter such as
;; 0.99 is the flonum, exactly, there as here.

(require "integrals.rkt")

(provide hard-integrals)

;; Ranges much longer than what matters in them.
(define long-ranges
  (hard
   ["e^(−x) to 10⁶"
    (lambda (x) (exp (- x)))
    0 1e6 "1.0"]
   ["e^(−x²) on ±10⁶"
    (lambda (x) (exp (- (* x x))))
    -1e6 1e6 "1.77245385090551602729816748334"]
   ["e^(−x) to 10⁴"
    (lambda (x) (exp (- x)))
    0 1e4 "1.0"]
   ["e^(−x²) on ±100"
    (lambda (x) (exp (- (* x x))))
    -100 100 "1.77245385090551602729816748334"]
   ["e^(−x²) from −10⁶ to 3"
    (lambda (x) (exp (- (* x x))))
    -1e6 3 "1.77243427371227924754356831958"]
   ["x e^(−x) to 10⁸"
    (lambda (x) (* x (exp (- x))))
    0 1e8 "1.0"]
   ["1/(1 + x²) to 10⁶"
    (lambda (x) (/ 1 (+ 1 (* x x))))
    0 1e6 "1.57079532679489661956465502497"]
   ["1/(1 + x²) on ±10⁸"
    (lambda (x) (/ 1 (+ 1 (* x x))))
    -1e8 1e8 "3.14159263358979323846264404995"]
   ["1/x from 1 to 10¹⁰"
    (lambda (x) (/ 1 x))
    1 1e10 "23.0258509299404568401799145468"]
   ["1/(1 + x) to 10⁸"
    (lambda (x) (/ 1 (+ 1 x)))
    0 1e8 "18.4206807539523654221439319708"]
   ["x⁻² from 1 to 10⁸"
    (lambda (x) (expt x -2))
    1 1e8 "0.99999999"]
   ["e^(−|x|) on ±10⁵"
    (lambda (x) (exp (- (abs x))))
    -1e5 1e5 "2.0"]
   ["sech² on ±1000"
    (lambda (x) (/ 1 (square (cosh x))))
    -300 300 "2.0"]
   ["x e^(−x²/2) to 1000"
    (lambda (x) (* x (exp (* -1/2 x x))))
    0 1000 "1.0"]
   ["e^(−1000(1 − x))"
    (lambda (x) (exp (* 1000 (- x 1))))
    0 1 "0.001"]
   ["x/(e^x + 1)"
    (lambda (x) (/ x (+ (exp x) 1)))
    0 700 "0.822467033424113218236207583323"]))

;; Interior peaks, a hundredth to a millionth of the interval wide.
(define narrow-peaks
  (hard
   ["e^(−((x − 3/10)/1e-3)²)"
    (lambda (x) (exp (- (square (/ (- x 3/10) 1e-3)))))
    0 1 "0.00177245385090551606419477514636"]
   ["e^(−((x − 0.7123)/1e-3)²)"
    (lambda (x) (exp (- (square (/ (- x 0.7123) 1e-3)))))
    0 1 "0.00177245385090551606419477514636"]
   ["e^(−((x − 0.1)/1e-3)²)"
    (lambda (x) (exp (- (square (/ (- x 0.1) 1e-3)))))
    0 1 "0.00177245385090551606419477514636"]
   ["e^(−((x − 0.55)/2e-3)²)"
    (lambda (x) (exp (- (square (/ (- x 0.55) 2e-3)))))
    0 1 "0.00354490770181103212838955029271"]
   ["e^(−((x − 0.91)/1e-3)²)"
    (lambda (x) (exp (- (square (/ (- x 0.91) 1e-3)))))
    0 1 "0.00177245385090551606419477514636"]
   ["1 and a peak of width 10⁻³"
    (lambda (x) (+ 1 (exp (- (square (/ (- x 0.317) 1e-3))))))
    0 1 "1.00177245385090551606419477515"]
   ["sin x and a peak of width 10⁻³"
    (lambda (x) (+ (sin x) (exp (- (square (/ (- x 2.2) 3e-3))))))
    0 pi "2.00531736155271654819258432544"]
   ["Lorentz, width 10⁻⁵"
    (lambda (x) (/ 1e-5 (+ 1e-10 (square (- x 1/3)))))
    0 1 "3.14154765358980356322326873126"]
   ["two peaks far apart"
    (lambda (x) (+ (exp (- (square (* 1000 (- x 0.2))))) (exp (- (square (* 1000 (- x 0.8)))))))
    0 1 "0.00354490770181103205459633496668"]
   ["a box of width 10⁻²"
    (lambda (x) (if (< 0.611 x 0.621) 1 0))
    0 1 "0.0100000000000000088817841970013"]
   ["a tent of width 10⁻²"
    (lambda (x) (max 0 (- 1 (abs (* 200 (- x 0.4321))))))
    0 1 "0.005"]
   ["sech²(1000(x − 0.45))"
    (lambda (x) (/ 1 (square (cosh (* 600 (- x 0.45))))))
    0 1 "0.00333333333333333333333333333333"]
   ["Breit and Wigner on a slope"
    (lambda (x) (+ x (/ 1e-6 (+ 1e-6 (square (- x 0.77))))))
    0 1 "0.503135946154330474281430352785"]))

;; Infinite at an end, down to x^−0.99, or falling to it slowly.
(define ends
  (hard
   ["x^-0.5"
    (lambda (x) (expt x -0.5))
    0 1 "2.0"]
   ["x^-0.9"
    (lambda (x) (expt x -0.9))
    0 1 "10.0000000000000022204460492503"]
   ["x^-0.95"
    (lambda (x) (expt x -0.95))
    0 1 "19.9999999999999822364316059975"]
   ["x^-0.98"
    (lambda (x) (expt x -0.98))
    0 1 "49.9999999999999555910790149938"]
   ["x^-0.99"
    (lambda (x) (expt x -0.99))
    0 1 "99.9999999999999111821580299876"]
   ["x^−0.99 to 3"
    (lambda (x) (expt x -0.99))
    0 3 "101.104669193785270253123383407"]
   ["x^−0.97 cos x"
    (lambda (x) (* (expt x -0.97) (cos x)))
    0 1 "33.0971397693380533620112224785"]
   ["x^−0.99 e^(−x)"
    (lambda (x) (* (expt x -0.99) (exp (- x))))
    0 +inf.0 "99.4325851191505149043169814984"]
   ["x^−0.9 log x"
    (lambda (x) (* (expt x -0.9) (log x)))
    0 1 "-100.000000000000044408920985006"]
   ["x^−1/2 log² x"
    (lambda (x) (/ (square (log x)) (sqrt x)))
    0 1 "16.0"]
   ["log³ x"
    (lambda (x) (expt (log x) 3))
    0 1 "-6.0"]
   ["√x log x"
    (lambda (x) (* (sqrt x) (log x)))
    0 1 "-0.444444444444444444444444444444"]
   ["x^0.01"
    (lambda (x) (expt x 0.01))
    0 1 "0.990099009900990098805835881661"]
   ["(1 − x)^−1/2"
    (lambda (x) (/ 1 (sqrt (- 1 x))))
    0 1 "2.0"]
   ["(2 − x)^−3/4"
    (lambda (x) (expt (- 2 x) -3/4))
    0 2 "4.75682846001088426686999988224"]
   ["x^−2/3 (1 − x)^−1/3"
    (lambda (x) (* (expt x -2/3) (expt (- 1 x) -1/3)))
    0 1 "3.62759872846843570118815651528"]
   ["x^−3/4 (1 − x)^−1/4"
    (lambda (x) (* (expt x -3/4) (expt (- 1 x) -1/4)))
    0 1 "4.44288293815836624701588099006"]
   ["log(1/x)^−1/2"
    (lambda (x) (/ 1 (sqrt (log (/ 1 x)))))
    0 1 "1.77245385090551602729816748334"]
   ["log x/(1 + x)"
    (lambda (x) (/ (log x) (+ 1 x)))
    0 1 "-0.822467033424113218236207583323"]
   ["log log(1/x)/(1 + x²)"
    (lambda (x) (/ (log (log (/ 1 x))) (+ 1 (* x x))))
    0 1 "-0.26044280630098844554009386879" 0.8]
   ["log tan x"
    (lambda (x) (log (tan x)))
    0 (/ pi 4) "-0.915965594177219015054603514932"]
   ["1/(x log² x) to 1/2"
    (lambda (x) (/ 1 (* x (square (log x)))))
    0 1/2 "1.442695040888963407359924681"]
   ["1/(x log² x) to 1/10"
    (lambda (x) (/ 1 (* x (square (log x)))))
    0 1/10 "0.434294481903251827651128918917"]
   ["1/(x |log x|³) to 1/2"
    (lambda (x) (/ 1 (* x (expt (- (log x)) 3))))
    0 1/2 "1.04068449050280389893479080187"]
   ["1/(x |log x|^3/2) to 1/2"
    (lambda (x) (/ 1 (* x (expt (- (log x)) 3/2))))
    0 1/2 "2.40224481757289958971560657219"]
   ["x^−1/2 sin x"
    (lambda (x) (/ (sin x) (sqrt x)))
    0 1 "0.620536603446762203616304846331"]
   ["|x − 1/3|^−1/2"
    (lambda (x) (/ 1 (sqrt (abs (- x 1/3)))))
    0 1 "2.78769370023470359448315361081"]
   ["|x|^−3/4 across 0"
    (lambda (x) (expt (abs x) -3/4))
    -1 2 "8.75682846001088426686999988224"]
   ["|x|^−0.95 across 0"
    (lambda (x) (expt (abs x) -0.95))
    -1 1 "39.999999999999964472863211995"]
   ["log|x| across 0"
    (lambda (x) (log (abs x)))
    -1 2 "-1.61370563888010938116553575708"]))

;; Slow or fast tails to infinity.
(define tails
  (hard
   ["x^−1.01"
    (lambda (x) (expt x -1.01))
    1 +inf.0 "99.9999999999999111821580299876"]
   ["x^−1.1"
    (lambda (x) (expt x -1.1))
    1 +inf.0 "9.99999999999999111821580299876"]
   ["x^−1.001"
    (lambda (x) (expt x -1.001))
    1 +inf.0 "1000.00000000011013412404282766"]
   ["(1 + x)^−1.02"
    (lambda (x) (expt (+ 1 x) -1.02))
    0 +inf.0 "49.9999999999999555910790149938"]
   ["x^−1.2 log x"
    (lambda (x) (* (expt x -1.2) (log x)))
    1 +inf.0 "25.0000000000000111022302462516"]
   ["1/(x log² x) from 2"
    (lambda (x) (/ 1 (* x (square (log x)))))
    2 +inf.0 "1.442695040888963407359924681"]
   ["1/(x log² x) from 10"
    (lambda (x) (/ 1 (* x (square (log x)))))
    10 +inf.0 "0.434294481903251827651128918917"]
   ["1/(x log³ x) from 3"
    (lambda (x) (/ 1 (* x (expt (log x) 3))))
    3 +inf.0 "0.414267724845111522187745870054"]
   ["log x/x²"
    (lambda (x) (/ (log x) (* x x)))
    1 +inf.0 "1.0"]
   ["1/(1 + x⁴)"
    (lambda (x) (/ 1 (+ 1 (expt x 4))))
    -inf.0 +inf.0 "2.22144146907918312350794049503"]
   ["1/(1 + x³)"
    (lambda (x) (/ 1 (+ 1 (expt x 3))))
    0 +inf.0 "1.20919957615614523372938550509"]
   ["1/√(1 + x³)"
    (lambda (x) (/ 1 (sqrt (+ 1 (expt x 3)))))
    0 +inf.0 "2.8043642106509085223500381581"]
   ["x e^(−√x)"
    (lambda (x) (* x (exp (- (sqrt x)))))
    0 +inf.0 "12.0"]
   ["e^(−x^1/4)"
    (lambda (x) (exp (- (expt x 1/4))))
    0 +inf.0 "24.0"]
   ["atan²(1/x)"
    (lambda (x) (square (atan (/ 1 x))))
    0 +inf.0 "2.17758609030360213050068889824"]
   ["x³/(e^x − 1)"
    (lambda (x) (/ (expt x 3) (- (exp x) 1)))
    0 700 "6.49393940226682914909602217925"]
   ["e^(−(x − 3)²)"
    (lambda (x) (exp (- (square (- x 3)))))
    -inf.0 +inf.0 "1.77245385090551602729816748334"]
   ["e^(−(x − 40)²)"
    (lambda (x) (exp (- (square (- x 40)))))
    -inf.0 +inf.0 "1.77245385090551602729816748334"]
   ["x²⁰ e^(−x)"
    (lambda (x) (* (expt x 20) (exp (- x))))
    0 +inf.0 "2432902008176640000.0"]
   ["e^(−100 x²)"
    (lambda (x) (exp (* -100 x x)))
    -inf.0 +inf.0 "0.177245385090551602729816748334"]
   ["1/(1 + (x − 1000)²)"
    (lambda (x) (/ 1 (+ 1 (square (- x 1000)))))
    0 +inf.0 "3.14059265392312637179611957364"]
   ["x e^(−x²)"
    (lambda (x) (* x (exp (- (* x x)))))
    -1 +inf.0 "0.183939720585721160797761885081" 0.82]))

;; Waves to infinity, or to a point.
(define waves
  (hard
   ["(sin x/x)²"
    (lambda (x) (if (= x 0) 1 (square (/ (sin x) x))))
    0 +inf.0 "1.57079632679489661923132169164"]
   ["(sin x/x)² on the line"
    (lambda (x) (if (= x 0) 1 (square (/ (sin x) x))))
    -inf.0 +inf.0 "3.14159265358979323846264338328"]
   ["(sin x/x)⁴"
    (lambda (x) (if (= x 0) 1 (expt (/ (sin x) x) 4)))
    0 +inf.0 "1.04719755119659774615421446109"]
   ["(1 − cos x)/x²"
    (lambda (x) (/ (* 2 (square (sin (/ x 2)))) (* x x)))
    0 +inf.0 "1.57079632679489661923132169164"]
   ["sin² x/(1 + x²)"
    (lambda (x) (/ (square (sin x)) (+ 1 (* x x))))
    0 +inf.0 "0.679106080500539227505880255518"]
   ["(2 + cos x)/(1 + x²)"
    (lambda (x) (/ (+ 2 (cos x)) (+ 1 (* x x))))
    0 +inf.0 "3.71945632848525409741768997494"]
   ["sin x²"
    (lambda (x) (sin (* x x)))
    0 +inf.0 "0.626657068657750125603941321203" 1.0]
   ["cos x²"
    (lambda (x) (cos (* x x)))
    0 +inf.0 "0.626657068657750125603941321203" 1.0]
   ["sin x³"
    (lambda (x) (sin (* x x x)))
    0 +inf.0 "0.446489755784624605609282156829" 1.0]
   ["Airy's, cos(t³/3)/π"
    (lambda (x) (/ (cos (/ (expt x 3) 3)) pi))
    0 +inf.0 "0.355028053887817239260063186004" 0.5]
   ["Airy's at 1"
    (lambda (x) (/ (cos (+ (/ (expt x 3) 3) x)) pi))
    0 +inf.0 "0.135292416312881415524147423515" 0.5]
   ["Airy's at −2"
    (lambda (x) (/ (cos (- (/ (expt x 3) 3) (* 2 x))) pi))
    0 +inf.0 "0.227407428201685575991924436038" 0.7]
   ["sin x²/x"
    (lambda (x) (/ (sin (* x x)) x))
    0 +inf.0 "0.78539816339744830961566084582"]
   ["cos x/√x"
    (lambda (x) (/ (cos x) (sqrt x)))
    0 +inf.0 "1.25331413731550025120788264241" 2.0]
   ["sin x/x^0.9"
    (lambda (x) (/ (sin x) (expt x 0.9)))
    0 +inf.0 "1.48824048749736097581625069128" 1.5]
   ["sin x/x^1.5"
    (lambda (x) (/ (sin x) (expt x 1.5)))
    0 +inf.0 "2.50662827463100050241576528481"]
   ["sin x/x^0.2"
    (lambda (x) (/ (sin x) (expt x 0.2)))
    0 +inf.0 "1.10724825570289097193241063427" 1.0]
   ["sin 3x/(x (1 + x²))"
    (lambda (x) (/ (sin (* 3 x)) (* x (+ 1 (* x x)))))
    0 +inf.0 "1.49259098268076954880444340584"]
   ["sin x e^(−x/10)"
    (lambda (x) (* (sin x) (exp (* -1/10 x))))
    0 +inf.0 "0.990099009900990099009900990099" 6.0]
   ["cos 5x e^(−x²)"
    (lambda (x) (* (cos (* 5 x)) (exp (- (* x x)))))
    -inf.0 +inf.0 "0.00342164086775328488336015251509" 1.2]
   ["log x sin x/x"
    (lambda (x) (/ (* (log x) (sin x)) x))
    0 +inf.0 "-0.906688246195801749806567265636" 1.7]
   ["sin(1/x)"
    (lambda (x) (sin (/ 1 x)))
    0 1 "0.504067061906928371989856117741" 0.55]
   ["sin(1/x) to 2"
    (lambda (x) (sin (/ 1 x)))
    0 2 "1.1366351560150189018823861415"]
   ["x sin(1/x)"
    (lambda (x) (* x (sin (/ 1 x))))
    0 1 "0.378530017124161309881735275628"]
   ["cos(1/x)"
    (lambda (x) (cos (/ 1 x)))
    0 1 "-0.0844109505595738868890317703736" 0.4]
   ["sin(1/x)/x"
    (lambda (x) (/ (sin (/ 1 x)) x))
    0 1 "0.624713256427713604289968377817" 0.9]
   ["cos(log x)"
    (lambda (x) (cos (log x)))
    0 1 "0.5" 0.8]
   ["sin(log x)/√x"
    (lambda (x) (/ (sin (log x)) (sqrt x)))
    0 1 "-0.8" 1.2]))

;; Finite ranges: waves, kinks, jumps, poles nearby.
(define finite-ranges
  (hard
   ["sin(100 x) e^x"
    (lambda (x) (* (sin (* 100 x)) (exp x)))
    0 1 "-0.0135765440064468964516886376388" 1.1]
   ["cos(cosh x)"
    (lambda (x) (cos (cosh (* 3 x))))
    0 1 "-0.0632623318054484473963520974178" 0.6]
   ["T₂₀(x) e^x"
    (lambda (x) (* (exp x) (cos (* 20 (acos x)))))
    -1 1 "-0.00778012684250322975420941910782" 1.5]
   ["|cos 5x|"
    (lambda (x) (abs (cos (* 5 x))))
    0 pi "2.0"]
   ["max(sin x, cos x)"
    (lambda (x) (max (sin x) (cos x)))
    0 pi "2.41421356237309504880168872421"]
   ["floor(x²)"
    (lambda (x) (floor (* x x)))
    0 2 "1.85373563005802765767086493428"]
   ["x − floor x"
    (lambda (x) (- x (floor x)))
    0 7/2 "1.625"]
   ["√|x² − 1/2|"
    (lambda (x) (sqrt (abs (- (* x x) 1/2))))
    0 1 "0.525909075537112160700100272717"]
   ["x⁷ √(1 − x²)"
    (lambda (x) (* (expt x 7) (sqrt (- 1 (* x x)))))
    0 1 "0.0507936507936507936507936507937"]
   ["e^(x) to 10"
    (lambda (x) (exp x))
    -10 10 "22026.4657494067867544730491097"]
   ["1/(1 + 25 x²)"
    (lambda (x) (/ 1 (+ 1 (* 25 x x))))
    -1 1 "0.549360306778006344344508770578"]
   ["1/(x² + 10⁻⁸)"
    (lambda (x) (/ 1 (+ 1e-8 (* x x))))
    -1 1 "31413.9265359045987226022835088"]
   ["x^30"
    (lambda (x) (expt x 30))
    -1 1 "0.0645161290322580645161290322581"]
   ["1/(2 + sin 10πx)"
    (lambda (x) (/ 1 (+ 2 (sin (* 10 pi x)))))
    0 1 "0.577350269189625764509148780502"]
   ["e^(20(x − 1)) sin 256x"
    (lambda (x) (* (exp (* 20 (- x 1))) (sin (* 256 x))))
    0 1 "-0.000148594479678924305369050722537" 0.035]
   ["√(1 − 0.81 sin²)"
    (lambda (x) (sqrt (- 1 (* 0.81 (square (sin x))))))
    0 (/ pi 2) "1.17169705278161410470967347255"]
   ["1/√(1 − 0.99 sin²)"
    (lambda (x) (/ 1 (sqrt (- 1 (* 0.99 (square (sin x)))))))
    0 (/ pi 2) "3.69563736298987423863839474194"]))

(define hard-integrals
  (append long-ranges narrow-peaks ends tails waves finite-ranges))
