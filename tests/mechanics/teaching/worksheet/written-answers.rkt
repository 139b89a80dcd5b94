#lang mechanics
;; Answers that are texts: what names mean is known from the exercise; what was read is told.

(require mechanics/book
         mechanics/teaching/class/answer-lines
         mechanics/teaching/worksheet/answer-data
         mechanics/teaching/worksheet/exercise
         mechanics/teaching/worksheet/exercise-kind
         mechanics/teaching/worksheet/judge
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/make-worksheet
         mechanics/teaching/worksheet/written-answer
         (except-in "../../support/checks.rkt" check))

(define-syntax-rule (an-exercise kind clause ...)
  (make-exercise 'item 'kind "?" (list (list . clause) ...)))

(define (judgment-of e text) (judge e (answer->datum text (rounds-of e))))
(define (told e text) (car (reverse (judgment-words (judgment-of e text)))))

(define (L-bowl (up t r rdot))
  (- (* 1/2 'm (+ 1 (* 4 (square 'a) (square r))) (square rdot)) (* 'm 'g 'a (square r))))
(define bowl (an-exercise equations ('coordinates 'r) ('of L-bowl)))
(define answer "m*(1 + 4*a^2*r^2)*r'' + 4 m a^2 r r'^2 + 2 m g a r")

(test-case "an answer as on paper is judged, and told as it was read"
  (check-equal? (judgment-status (judgment-of bowl answer)) 'right)
  (check-equal? (told bowl answer) "read as m (1 + 4 a² r²) r̈ + 4 m a² r ṙ² + 2 m g a r")
  (check-equal? (judgment-status (judgment-of bowl "m*(1 + 4*a^2*r^2)*r'' + 8 m a^2 r r'^2"))
                'wrong))

(test-case "a function may have a text as its value"
  (check-equal? (judgment-status (judgment-of bowl (lambda (r) (lambda (t) answer)))) 'right))

(test-case "a list of texts is one, with commas between"
  (define e (an-exercise expression ('key (up 'a 'b))))
  (check-equal? (judgment-status (judgment-of e (list "a" "b"))) 'right))

(test-case "a text comes out of a student's process as it was"
  (define out (open-output-string))
  (define d '(text "½ m θ̇² − \\frac{m}{2} \"V\"(r)\n"))
  (write-line-of 'motion d out)
  (check-equal? (hash-ref (read-answer-lines (get-output-string out)) 'motion) d))

(define (datum-of e text) (cadr (read-written-answer e text)))

(test-case "coordinates have rates and momenta, in all spellings"
  (define two (an-exercise function ('coordinates 'x_1 'theta) ('key (lambda (s) (* 'k (time s))))))
  (for ([text '("x_1'" "x1'" "xdot_1" "ẋ₁" "\\dot{x}_1" "\\dot{x}_{1}" "x_1_dot" "x_{1}'"
                       "D x_1" "dx_1/dt" "x_1'(t)" "ẋ₁(t)")])
    (check-equal? (datum-of two text) 'xdot_1 text))
  (for ([text '("theta'" "θ'" "θ̇" "\\dot\\theta" "theta_dot" "thetadot" "dθ/dt"
                         "\\dot{\\theta}(t)")])
    (check-equal? (datum-of two text) 'thetadot text))
  (define state (an-exercise phase-function ('coordinates 'theta) ('key (lambda (s) 0))))
  (for ([text '("p" "p_theta" "p_θ" "p_\\theta" "p_{\\vartheta}")])
    (check-equal? (datum-of state text) 'p_theta text)))

(test-case "constants are known by the key, and where they are not, as they stand"
  (define e (an-exercise expression ('key (* 'm 'a 'rho_0))))
  (check-equal? (datum-of e "ma rho_0") '(* m a rho_0))
  (check-equal? (datum-of e "maρ₀") '(* m a rho_0))
  (check-equal? (datum-of e "mb") 'mb)
  (check-equal? (hash-ref (exercise-settings e) 'names) '(m a rho_0)))

(test-case "functions of the key are known, also those that are differentiated there"
  (define-values (U V) (values (literal-function 'U) (literal-function 'V)))
  (define e (an-exercise expression ('key (+ (* 'k (U 'x)) ((D V) 'x)))))
  (check-equal? (hash-ref (exercise-settings e) 'functions) '(U V))
  (check-equal? (datum-of e "k U(x)") '(* k (U x))))

(test-case "what is called something else is the right side"
  (define e (an-exercise expression ('key (* 'm 'g))))
  (check-equal? (datum-of e "F = m g") '(* m g))
  (check-equal? (datum-of e "F(t) = m g") '(* m g))
  (check-equal? (read-written-answer e "m g = m a")
                '(failed "it is an equation where an expression is expected"))
  (check-equal? (datum-of e "m, g") '(up m g)))

(define energy
  (an-exercise conserved ('coordinates 'x) ('of (L-harmonic 'm 'k))
               ('key (Lagrangian->energy (L-harmonic 'm 'k)))))

(test-case "of a conserved quantity the side that moves is read"
  (for ([text '("E = m x'^2/2 + k x^2/2 = const"
                "E = m x'^2/2 + k x^2/2" "m x'^2 + k x^2 = 2 E" "m x'^2 + k x^2 - 2 E = 0")])
    (check-equal? (judgment-status (judgment-of energy text)) 'right text))
  (check-equal? (judgment-status (judgment-of energy "E = const")) 'wrong)
  (check-equal? (read-written-answer energy "m x'^2/2 = C - k x^2/2")
                '(failed "it is an equation where an expression is expected")))

(test-case "a side that stands there twice is one"
  (check-equal? (judgment-status (judgment-of bowl (string-append answer " = 0 = 0"))) 'right))

(test-case "a list takes up and down from the key"
  (define e (an-exercise expression ('key (down 'a (up 'b 'c)))))
  (check-equal? (datum-of e "[a, (b, c)]") '(down a (up b c))))

(test-case "a unit that the question names may stand behind"
  (define e (an-exercise number ('key 2) ('unit "m/s")))
  (for ([text '("2 m/s" "2m/s" "2")]) (check-equal? (datum-of e text) 2 text)))

(test-case "names in a number, as another unit, are not judged but told"
  (define (told e text)
    (define j (judgment-of e text))
    (list (judgment-status j) (car (judgment-words j))))
  (define seconds (an-exercise number ('key 2) ('unit "s")))
  (check-equal? (told seconds "2000 ms") '(failed "it has ms in it: give the number alone, in s"))
  (check-equal? (told seconds "2 seconds")
                '(failed "it has seconds in it: give the number alone, in s"))
  (check-equal? (told (an-exercise number ('key 2)) "2 s")
                '(failed "it has s in it: give the number alone")))

(define (with-given source e)
  (car (exercises-of (make-worksheet "W" #f "w" (list (given source) e)))))

(test-case "a text may use the numbers that the worksheet gives, by their names"
  (define numbers "(define k 20)\n(define m 0.2) ; kg\n(define (f x) x)")
  (define period (with-given numbers (an-exercise number ('key (* 2 pi (sqrt (/ 0.2 20)))))))
  (for ([text '("2 pi sqrt(m/k)" "2π√(m/k)" "T = 2 pi sqrt(m/k)")])
    (check-equal? (judgment-status (judgment-of period text)) 'right text))
  (check-equal? (judgment-status (judgment-of period "2 pi sqrt(k/m)")) 'wrong)
  (define weight (with-given numbers (an-exercise expression ('key (* 'm 'g)))))
  (check-equal? (datum-of weight "m g") '(* m g))
  (check-equal? (judgment-status (judgment-of weight "m g")) 'right))

(define (two-readings a b)
  (format "it has two readings, ~a and ~a: parentheses or a sign * tell which is meant" a b))

(define-syntax-rule (refuses e [text why] ...)
  (begin (test-case text (check-equal? (read-written-answer e text) (list 'failed why))) ...))

(refuses bowl
 ["1/2m r''" (two-readings "½ m r̈" "1/(2 m r̈)")]
 ["f(r + 1)" (two-readings "f (r + 1)" "f(r + 1)")]
 ["r'' = 1 = 2" "there are several = in one equation"]
 ["r''' = 0" "r has more than two primes"]
 ["1,5 r''" (string-append "1,5 has two readings: the number 1.5, which is written with a point, "
                           "and the list 1, 5, which has a space behind the comma")])

(test-case "a million characters, or numbers as large, are refused at once"
  (check-equal? (judgment-words (judgment-of bowl (make-string 1000000 #\x)))
                '("it has more than 4000 characters"))
  (check-equal? (car (judgment-words (judgment-of bowl "9^(9^(9^9)) r")))
                "answer: it comes to more than can be calculated with")
  (check-equal? (judgment-status (judgment-of bowl (make-string 4000 #\())) 'failed))

(test-case "a name alone is no answer to a question that does not have it"
  (check-equal? (judgment-words (judgment-of (an-exercise expression ('key 'a)) "hello"))
                '("it has hello in it, of which the question does not speak" "read as hello")))

(test-case "the question tells how a velocity is written, and so do the words on a v"
  (check-equal? (answer-names energy)
                (string-append "or as on paper, in quotation marks. Names in it: m, k; "
                               "the coordinate x, its velocity x'"))
  (check-equal? (car (judgment-words (judgment-of energy "1/2 m v^2 + 1/2 k x^2")))
                "v stands for nothing here; the velocity is x'")
  (define two (an-exercise function ('coordinates 'x 'y) ('key (lambda (s) (* 'm (time s))))))
  (check-equal? (car (judgment-words (judgment-of two "m vx^2 + m vy^2")))
                "vx, vy stand for nothing here; the velocities are x', y'")
  (define state (an-exercise phase-function ('coordinates 'x 'y) ('key (lambda (s) (time s)))))
  (check-regexp-match #rx"Names in it: the coordinates x, y, their momenta p_x, p_y$"
                      (answer-names state))
  (check-regexp-match #rx"its velocity r', its acceleration r''$" (answer-names bowl)))

(test-case "without its key an answer is kept, and still read"
  (define e (struct-copy exercise bowl [key #f]))
  (check-equal? (judgment-status (judgment-of e "m r''")) 'kept)
  (check-equal? (told e "m r''") "read as m r̈")
  (check-equal? (judgment-status (judgment-of e "m r'' +")) 'failed))
