#lang racket/base
;; Picts as elements of SVG: where they are and how they look.

(require (only-in mechanics/show/animation/on-demand why-no-pictures)
         racket/list
         xml
         "../../support/checks.rkt" "../../support/skip.rkt")

(skip-unless (not (why-no-pictures))
             "the shared libraries of racket/draw are not installed: nothing is recorded"

  (define (library name) (dynamic-require 'mechanics/show/animation/pict-recorder name))
  (define (svg name) (dynamic-require 'mechanics/show/animation/svg name))
  (define (pict name) (dynamic-require 'pict name))
  (define (color . bytes) (apply (dynamic-require 'racket/draw 'make-color) bytes))

  ;; -> xexprs, with the look as the attribute class
  (define (elements p)
    (for/list ([e (in-list ((library 'record-pict) p))])
      (string->xexpr ((svg 'element->markup) e (svg 'look->css)))))
  (define (attribute e name)
    (cond [(assq name (cadr e)) => cadr] [else #f]))

  (test-case "a line, a filled and an open disc, a rectangle"
    (define line (first (elements ((pict 'linewidth) 3 ((pict 'hline) 20 10)))))
    (check-equal? (attribute line 'd) "M0 5L20 5")
    (check-equal? (attribute line 'class) "fill:none;stroke:var(--ink);stroke-width:3;")
    (define disk (first (elements ((pict 'disk) 10 #:color "red" #:draw-border? #f))))
    (check-equal? (list (attribute disk 'cx) (attribute disk 'rx)) '("5" "5"))
    (check-equal? (attribute disk 'class) "fill:rgb(255,0,0);fill-rule:evenodd;")
    (check-regexp-match #rx"^fill:none;" (attribute (first (elements ((pict 'circle) 8))) 'class))
    (check-equal? (attribute (first (elements ((pict 'filled-rectangle) 4 6 #:draw-border? #f))) 'd)
                  "M0 0L4 0L4 6L0 6Z"))

  (test-case "a point is a disc as wide as the pen"
    (define (draw! canvas x y)
      (define send (dynamic-require 'racket/class 'dynamic-send))
      (send canvas 'set-pen "red" 4 'solid)
      (send canvas 'draw-point (+ x 3) (+ y 5)))
    (define point (first (elements ((pict 'unsafe-dc) draw! 10 10))))
    (check-eq? (car point) 'ellipse)
    (check-equal? (map (lambda (name) (attribute point name)) '(cx cy rx ry)) '("3" "5" "2" "2"))
    (check-regexp-match #rx"^fill:rgb[(]255,0,0[)];" (attribute point 'class)))

  (test-case "lines and areas through points are where they were moved to"
    (define (path-of draw . more)
      (define send (dynamic-require 'racket/class 'dynamic-send))
      (define (draw! canvas x y)
        (apply send canvas draw '((0 . 0) (4 . 0) (4 . 2)) (+ x 3) (+ y 5) more))
      (attribute (last (elements ((pict 'unsafe-dc) draw! 10 10))) 'd))
    (check-equal? (path-of 'draw-lines) "M3 5L7 5L7 7")
    (check-regexp-match #rx"^M3 5L7 5L7 7Z?$" (path-of 'draw-polygon)))

  (test-case "black and white are the ink and the paper, half-transparent colors stay so"
    (define (fill p) (attribute (first (elements p)) 'class))
    (define ((filled c) p) ((pict 'colorize) p c))
    (define box ((pict 'filled-rectangle) 4 6 #:draw-border? #f))
    (check-regexp-match #rx"fill:var[(]--ink[)]" (fill box))
    (check-regexp-match #rx"fill:var[(]--paper[)]" (fill ((filled "white") box)))
    (check-regexp-match #rx"fill:rgba[(]10,20,30,.5[)]" (fill ((filled (color 10 20 30 0.5)) box)))
    (check-regexp-match #rx"fill:rgba[(]0,0,0,.25[)]" (fill ((pict 'cellophane) box 0.25))))

  (test-case "what is moved, scaled and turned is where it is seen"
    (define line ((pict 'hline) 10 0))
    (define (d p) (attribute (first (elements p)) 'd))
    (check-equal? (d ((pict 'inset) line 3 4 0 0)) "M3 4L13 4")
    (check-equal? (d ((pict 'scale) line 2 1)) "M0 0L20 0")
    (check-equal? (d ((pict 'rotate) line (acos 0))) "M0 10L0 0")
    (define disk ((pict 'rotate) ((pict 'scale) ((pict 'disk) 10) 2 1) 0.5))
    (check-regexp-match #rx"^M[^A-Z]*C" (d disk)))

  (test-case "text stands on its line, is as wide as it was, and can break nothing"
    (define e (first (elements ((pict 'text) "<&\"θ]]>" 'roman 20))))
    (check-eq? (car e) 'text)
    (check-equal? (apply string-append (for/list ([part (cddr e)])
                                         (if (symbol? part) (case part [(lt) "<"] [(gt) ">"]
                                                              [(amp) "&"] [else "?"])
                                             part)))
                  "<&\"θ]]>")
    (check-regexp-match #rx"font:normal normal" (attribute e 'style))
    (check-true (> (string->number (attribute e 'textLength)) 30))
    (define-values (there here)
      (values (first (elements ((pict 'inset) ((pict 'text) "a") 3 40 0 0)))
              (first (elements ((pict 'text) "a")))))
    (define (place e) (map (lambda (a) (string->number (attribute e a))) '(x y)))
    (for-each (lambda (a b d) (check-= (- a b) d 0.01)) (place there) (place here) '(3 40)))

  (test-case "a picture that is clipped is a picture within, a bitmap is an image"
    (define clipped
      (first (elements ((pict 'clip) ((pict 'pin-over) ((pict 'blank) 20 10) -5 -5
                                      ((pict 'filled-rectangle) 50 50 #:draw-border? #f))))))
    (check-eq? (car clipped) 'svg)
    (check-equal? (map (lambda (a) (attribute clipped a)) '(x y width height)) '("0" "0" "20" "10"))
    (define bits ((pict 'bitmap) ((pict 'pict->bitmap) ((pict 'disk) 9))))
    (define moved (first (elements ((pict 'inset) bits 3 4 0 0))))
    (check-equal? (map (lambda (a) (attribute moved a)) '(x y width height)) '("3" "4" "9" "9"))
    (define image (first (elements bits)))
    (check-eq? (car image) 'image)
    (check-equal? (attribute image 'width) "9")
    (check-regexp-match #rx"^data:image/png;base64,iVBOR" (attribute image 'href)))

  (test-case "numbers are short, and what is no number breaks no page"
    (check-equal? (map (svg 'number->svg) '(0 0.0 -0.5 0.25 3 -12.346 1/3 +nan.0 +inf.0))
                  '("0" "0" "-.5" ".25" "3" "-12.35" ".33" "0" "0"))))
